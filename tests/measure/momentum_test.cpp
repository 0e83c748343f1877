#include "retiarius/measure/momentum.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/bodies/primitives.hpp"
#include "tiny_nets.hpp"

namespace retiarius {
namespace {

// A ring of n nodes of 1 kg, radius r, turning at w about its axis and flying at v.
Network spinning_ring(int n, double r, double w, const Vec3& at, const Vec3& v) {
  std::vector<Vec3> places;
  std::vector<std::pair<Index, Index>> pairs;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * kPi * k / n;
    places.push_back(at + r * Vec3(std::cos(angle), std::sin(angle), 0.0));
    pairs.emplace_back(k, (k + 1) % n);
  }
  Network net = make_net(places, pairs);
  for (int k = 0; k < n; ++k) net.velocity[k] = v + w * Vec3::UnitZ().cross(places[k] - at);
  return net;
}

TEST(Momentum, OfASpinningRing) {
  const Vec3 at(5, 0, 0), v(0, 2, 0);
  const Network net = spinning_ring(12, 2.0, 3.0, at, v);
  const std::vector<Body> none;
  const State s = initial_state(net, none);
  EXPECT_EQ(total_mass(net, none), 12.0);
  EXPECT_NEAR((mass_center(net, none, s) - at).norm(), 0.0, 1e-14);
  EXPECT_NEAR((linear_momentum(net, none, s) - 12.0 * v).norm(), 0.0, 1e-12);
  const double spin = 12.0 * 3.0 * 4.0;  // n w r2
  EXPECT_NEAR((angular_momentum(net, none, s, at) - Vec3(0, 0, spin)).norm(), 0.0, 1e-11);
  EXPECT_NEAR((angular_momentum(net, none, s, Vec3::Zero()) - Vec3(0, 0, spin + 5.0 * 24.0)).norm(),
              0.0, 1e-11);
  EXPECT_NEAR(angular_scale(net, none, s), spin, 1e-11);
  EXPECT_EQ(angular_scale(spinning_ring(3, 1, 0, at, Vec3::Zero()), none,
                          initial_state(spinning_ring(3, 1, 0, at, Vec3::Zero()), none)),
            0.0);
}

TEST(Momentum, CountsFreeBodiesAndLeavesFixedOnesOut) {
  const Network net = make_net({{0, 0, 0}, {1, 0, 0}}, {{0, 1}});
  std::vector<Body> bodies = {make_body(make_sphere(1.0), ShapeKind::sphere, Vec3(0, 0, 4)),
                              make_body(make_sphere(1.0), ShapeKind::sphere, Vec3(0, 0, 9))};
  bodies[0].fixed = false;
  bodies[0].mass = 8.0;
  bodies[0].inertia = Mat3::Identity();
  bodies[0].initial.velocity = Vec3(0.5, 0, 0);
  bodies[0].initial.angular_momentum = Vec3(0, 0, 7);
  const State s = initial_state(net, bodies);
  EXPECT_EQ(total_mass(net, bodies), 10.0);
  EXPECT_NEAR((mass_center(net, bodies, s) - Vec3(0.1, 0, 3.2)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((linear_momentum(net, bodies, s) - Vec3(4, 0, 0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR(linear_scale(net, bodies, s), 4.0, 1e-14);
  EXPECT_NEAR((angular_momentum(net, bodies, s, Vec3(0, 0, 1)) - Vec3(0, 12, 7)).norm(), 0.0,
              1e-13);
}

TEST(MomentumDrift, IsWhatNoImpulseExplainsOverTheScale) {
  MomentumDrift drift;
  EXPECT_FALSE(drift.value().has_value());
  drift.rebase(Vec3(1, 0, 0), Vec3(5, 0, 0));
  drift.add(Vec3(3, 0, 0), Vec3(7, 0, 0), 2.0);
  EXPECT_EQ(drift.value(), 0.0);
  drift.add(Vec3(3, 0.5, 0), Vec3(7, 0, 0), 10.0);
  EXPECT_NEAR(*drift.value(), 0.05, 1e-15);
  drift.rebase(Vec3(3, 0.5, 0), Vec3(7, 0, 0));
  drift.add(Vec3(3, 0.5, 0), Vec3(7, 0, 0), 1.0);
  EXPECT_NEAR(*drift.value(), 0.05, 1e-15) << "the largest stays";
}

TEST(MomentumDrift, IsAbsentWhereNothingMoves) {
  MomentumDrift drift;
  drift.rebase(Vec3::Zero(), Vec3::Zero());
  drift.add(Vec3::Zero(), Vec3::Zero(), 0.0);
  EXPECT_FALSE(drift.value().has_value());
}

}  // namespace
}  // namespace retiarius

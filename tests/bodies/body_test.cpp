#include "retiarius/bodies/body.hpp"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/free_rotation.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

BodySpec ball() {
  BodySpec spec;
  spec.shape = ShapeKind::sphere;
  spec.radius = 0.5;
  spec.mass = 10.0;
  return spec;
}

// Body with principal moments 1, 2, 3 kg m2 that spins about its middle axis, slightly off.
BodySpec tumbler() {
  BodySpec spec = ball();
  spec.inertia = {1.0, 2.0, 3.0};
  spec.spin_deg = Vec3(degrees(0.01), degrees(1.0), 0.0);
  return spec;
}

Vec3 body_spin(const Body& body, const BodyState& state) {
  return state.attitude.conjugate() * spin(body, state);
}

TEST(BuildBody, TakesMassAndInertiaFromTheSolid) {
  const Body body = build_body(ball(), "");
  EXPECT_EQ(body.name, "target");
  EXPECT_EQ(body.mass, 10.0);
  EXPECT_TRUE(body.inertia.isApprox(Mat3::Identity(), 1e-14));  // 2/5 m r2 = 1

  BodySpec spec = ball();
  spec.mass.reset();
  spec.density = 1000.0;
  EXPECT_NEAR(build_body(spec, "").mass, 1000.0 * kPi / 6.0, 1e-10);
  EXPECT_NEAR(build_body(spec, "").inertia(1, 1), 1000.0 * kPi / 60.0, 1e-11);
}

TEST(BuildBody, PlacesTheBody) {
  BodySpec spec = ball();
  spec.inertia = {1.0, 2.0, 2.5};
  spec.position = Vec3(1.0, 2.0, 3.0);
  spec.velocity = Vec3(0.1, 0.2, 0.3);
  spec.attitude_deg = Vec3(0.0, 0.0, 90.0);
  spec.spin_deg = Vec3(180.0, 0.0, 0.0);
  const Body body = build_body(spec, "");
  EXPECT_EQ(body.initial.position, spec.position);
  EXPECT_EQ(body.initial.velocity, spec.velocity);
  // Body x points along world y, so the spin does too.
  EXPECT_LT((spin(body, body.initial) - Vec3(0.0, kPi, 0.0)).norm(), 1e-14);
  EXPECT_LT((body.initial.angular_momentum - Vec3(0.0, kPi, 0.0)).norm(), 1e-14);
  EXPECT_TRUE(world_inertia(body, body.initial.attitude)
                  .isApprox(Mat3(Vec3(2.0, 1.0, 2.5).asDiagonal()), 1e-14));
  const Vec3 world(1.5, 2.5, 2.0);
  EXPECT_LT((to_world(body.initial, to_body(body.initial, world)) - world).norm(), 1e-14);
  EXPECT_LT((to_body(body.initial, world) - Vec3(0.5, -0.5, -1.0)).norm(), 1e-14);
}

TEST(BuildBody, RefusesWhatNoBodyCanHave) {
  const auto refused = [](const std::function<void(BodySpec&)>& spoil, const std::string& text) {
    BodySpec spec = ball();
    spec.name = "stage";
    spoil(spec);
    EXPECT_THAT([&] { build_body(spec, ""); }, ThrowsMessage<InputError>(HasSubstr(text)));
  };
  refused([](auto& s) { s.mass = 0.0; }, "stage: mass is 0 kg; it must be positive and finite");
  refused([](auto& s) { s.mass = std::nan(""); }, "stage: mass is nan kg");
  refused([](auto& s) { s.density = -5.0; }, "stage: density is -5 kg/m3; it must be positive");
  refused([](auto& s) { s.density = 5.0; }, "stage: give mass or density, not both");
  refused([](auto& s) { s.mass.reset(); }, "stage: a free body needs mass (kg) or density (kg/m3)");
  refused(
      [](auto& s) {
        s.inertia = {1.0, 1.0, 2.5};
      },
      "stage: inertia[2] is 2.5 kg m2, more than the sum of the other two (2 kg m2)");
  refused([](auto& s) { s.inertia = {1.0, 0.0, 1.0}; }, "stage: inertia[1] is 0 kg m2");
  refused([](auto& s) { s.velocity.y() = kInfinity; },
          "stage: velocity is [0, inf, 0]; its numbers must be finite");
  refused([](auto& s) { s.position.x() = std::nan(""); }, "stage: position is [nan, 0, 0]");
  refused([](auto& s) { s.spin_deg.x() = kInfinity; }, "stage: spin_deg is [inf, 0, 0]");
  refused([](auto& s) { s.attitude_deg.z() = kInfinity; }, "stage: attitude_deg is [0, 0, inf]");
  refused([](auto& s) { s.shape = ShapeKind::plane; },
          "stage: a plane has no mass and must be fixed; set motion = \"fixed\"");
  refused(
      [](auto& s) {
        s.motion = BodyMotion::fixed;
        s.spin_deg = Vec3(0.0, 0.0, 1.0);
      },
      "stage: a fixed body cannot have velocity or spin_deg");
}

TEST(BuildBody, FixedBodyStaysAndHasNoEnergy) {
  BodySpec spec;
  spec.shape = ShapeKind::plane;
  spec.motion = BodyMotion::fixed;
  spec.position = Vec3(0.0, 0.0, -1.0);
  const Body body = build_body(spec, "");
  EXPECT_EQ(body.mass, kInfinity);
  BodyState state = body.initial;
  state.angular_momentum = Vec3(1.0, 2.0, 3.0);  // whatever contact may have left there
  EXPECT_EQ(free_motion(body, state, 1.0).position, spec.position);
  EXPECT_TRUE(free_motion(body, state, 1.0).attitude.isApprox(Quat::Identity(), 0.0));
  EXPECT_EQ(spin(body, state), Vec3::Zero());
  EXPECT_EQ(kinetic_energy(body, state), 0.0);
  EXPECT_EQ(point_velocity(body, state, Vec3::Ones()), Vec3::Zero());
}

TEST(BuildBody, TouchingTheTriangleInequalityIsAllowed) {
  BodySpec spec = ball();
  spec.inertia = {1.0, 2.0, 3.0};  // a flat plate
  EXPECT_EQ(build_body(spec, "").inertia(2, 2), 3.0);
}

// The body turns over about every 20.75461 s (Jacobi's elliptic functions), whatever the number of
// steps; its momentum stays the same bit for bit and its energy to 1e-6 over ten flips.
TEST(FreeMotion, TumblesWithTheFlipsOfTheExactSolution) {
  const Body body = build_body(tumbler(), "");
  BodyState state = body.initial;
  const double energy = kinetic_energy(body, state);
  constexpr double kStep = 0.01;
  std::vector<double> flips;
  double before = body_spin(body, state).y();
  for (int k = 1; k <= 21000; ++k) {
    state = free_motion(body, state, kStep);
    const double now = body_spin(body, state).y();
    if (before * now < 0.0) flips.push_back(kStep * (k - now / (now - before)));
    before = now;
    ASSERT_NEAR(kinetic_energy(body, state), energy, 1e-6 * energy);
  }
  ASSERT_EQ(flips.size(), 10u);
  EXPECT_NEAR(flips[0], 10.3773, 1e-4);
  EXPECT_NEAR(flips[1], 31.1319, 1e-4);
  EXPECT_NEAR(flips[2], 51.8865, 1e-4);
  EXPECT_NEAR((flips[9] - flips[0]) / 9.0, 20.75461, 1e-4);
  EXPECT_EQ(state.angular_momentum, body.initial.angular_momentum);
  EXPECT_NEAR(state.attitude.norm(), 1.0, 1e-15);
}

TEST(FreeMotion, OneLongStepEqualsManyShortOnes) {
  const Body body = build_body(tumbler(), "");
  const BodyState once = free_motion(body, body.initial, 1.0);
  BodyState many = body.initial;
  for (int k = 0; k < 100; ++k) many = free_motion(body, many, 0.01);
  EXPECT_LT((once.attitude.conjugate() * many.attitude).vec().norm(), 1e-9);
}

TEST(FreeMotion, RunsBackwards) {
  const Body body = build_body(tumbler(), "");
  const BodyState there = free_motion(body, body.initial, 0.3);
  const BodyState back = free_motion(body, there, -0.3);
  EXPECT_LT((back.attitude.conjugate() * body.initial.attitude).vec().norm(), 1e-9);
}

TEST(FreeMotion, MovesTheMassCentreStraight) {
  BodySpec spec = tumbler();
  spec.velocity = Vec3(1.0, -2.0, 0.5);
  const Body body = build_body(spec, "");
  const BodyState next = free_motion(body, body.initial, 0.5);
  EXPECT_LT((next.position - Vec3(0.5, -1.0, 0.25)).norm(), 1e-15);
  EXPECT_EQ(next.velocity, spec.velocity);
}

TEST(Displaced, ShiftsAndTurnsInWorldAxes) {
  BodySpec spec = ball();
  spec.attitude_deg = Vec3(90.0, 0.0, 0.0);
  spec.velocity = Vec3(1.0, 0.0, 0.0);
  spec.spin_deg = Vec3(0.0, 10.0, 0.0);
  const Body body = build_body(spec, "");
  const BodyState next = displaced(body.initial, Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, kPi / 2.0));
  EXPECT_EQ(next.position, Vec3(0.0, 1.0, 0.0));
  EXPECT_LT((next.attitude * Vec3::UnitY() - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((next.attitude * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(next.angular_momentum, body.initial.angular_momentum);
  EXPECT_EQ(next.velocity, body.initial.velocity);
  const BodyState same = displaced(body.initial, Vec3::Zero(), Vec3::Zero());
  EXPECT_EQ(same.attitude.coeffs(), body.initial.attitude.coeffs());
}

TEST(KineticEnergy, IsThatOfMovingAndTurning) {
  BodySpec spec = tumbler();
  spec.velocity = Vec3(3.0, 0.0, 4.0);
  spec.attitude_deg = Vec3(20.0, 30.0, 40.0);
  const Body body = build_body(spec, "");
  EXPECT_NEAR(kinetic_energy(body, body.initial),
              0.5 * 10.0 * 25.0 + 0.5 * (1.0 * 1e-4 + 2.0 * 1.0), 1e-12);
}

TEST(PointVelocity, IsTheRateOfAMaterialPoint) {
  BodySpec spec = tumbler();
  spec.velocity = Vec3(0.3, -0.1, 0.2);
  spec.spin_deg = Vec3(30.0, -50.0, 80.0);
  const Body body = build_body(spec, "");
  const Vec3 local(0.2, 0.4, -0.3);
  constexpr double kStep = 1e-5;
  const Vec3 ahead = to_world(free_motion(body, body.initial, kStep), local);
  const Vec3 behind = to_world(free_motion(body, body.initial, -kStep), local);
  const Vec3 rate = point_velocity(body, body.initial, to_world(body.initial, local));
  EXPECT_LT((rate - (ahead - behind) / (2.0 * kStep)).norm(), 1e-8);
}

}  // namespace
}  // namespace retiarius

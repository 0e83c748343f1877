#include "retiarius/measure/energy.hpp"

#include <gtest/gtest.h>

#include "retiarius/bodies/primitives.hpp"
#include "retiarius/measure/energy_balance.hpp"
#include "tiny_nets.hpp"

namespace retiarius {
namespace {

Body free_sphere() {
  Body b = make_body(make_sphere(1.0), ShapeKind::sphere, Vec3(0, 0, 5));
  b.fixed = false;
  b.mass = 10.0;
  b.inertia = 4.0 * Mat3::Identity();
  return b;
}

TEST(Energy, OfNodesAndFreeBodies) {
  Network net = make_net({{0, 0, 1}, {0, 0, 2}}, {{0, 1}});
  net.mass = {2.0, 3.0};
  net.velocity = {Vec3(1, 0, 0), Vec3(0, 2, 0)};
  std::vector<Body> bodies = {free_sphere()};
  bodies[0].initial.velocity = Vec3(0, 0, -1);
  bodies[0].initial.angular_momentum = Vec3(8, 0, 0);
  const State s = initial_state(net, bodies);
  EXPECT_NEAR(kinetic_energy(net, bodies, s), 1.0 + 6.0 + 5.0 + 8.0, 1e-13);
  EXPECT_NEAR(gravity_energy(net, bodies, s, Vec3(0, 0, -9)), 9.0 * (2.0 + 6.0 + 50.0), 1e-11);
  EXPECT_EQ(gravity_energy(net, bodies, s, Vec3(7, 0, 0)), 0.0);
}

TEST(Energy, FixedBodiesHaveNone) {
  const Network net = make_net({{0, 0, 0}, {0, 0, 1}}, {{0, 1}});
  const std::vector<Body> bodies = {make_body(make_plane(), ShapeKind::plane, Vec3(0, 0, -3))};
  const State s = initial_state(net, bodies);
  EXPECT_EQ(kinetic_energy(net, bodies, s), 0.0);
  EXPECT_NEAR(gravity_energy(net, bodies, s, Vec3(0, 0, -10)), 10.0, 1e-14);
}

// A mass on a spring, pulled and let go: what implicit Euler loses is exactly what is missing.
TEST(EnergyBalance, LossIsWhatIsMissing) {
  Network net = make_net({{0, 0, 0}, {1, 0, 0}}, {{0, 1}}, 100.0, 0.9);
  const std::vector<Body> none;
  Simulation sim = start(net, none);
  EnergyBalance balance;
  balance.begin(sim);
  const double first = energies(sim, Vec3::Zero()).sum();
  EXPECT_NEAR(first, 0.5 * 100.0 * 0.9 * (0.1 / 0.9) * (0.1 / 0.9), 1e-12);
  double before = 0.0;
  for (int k = 1; k <= 8; ++k) {
    sim.advance(0.01 * k, {});
    balance.see(sim);
    const Energies now = energies(sim, Vec3::Zero());
    const double loss = balance.integrator_loss(now, sim.state().account);
    EXPECT_NEAR(loss, first - now.kinetic - now.stretching, 1e-13);
    EXPECT_GT(loss, before);
    before = loss;
  }
}

TEST(EnergyBalance, WorkOfAKickIsNoLoss) {
  const Network net = make_net({{0, 0, 0}, {1, 0, 0}}, {{0, 1}});
  const std::vector<Body> none;
  Simulation sim = start(net, none);
  EnergyBalance balance;
  balance.begin(sim);
  sim.kick(1, Vec3(0, 4, 0));
  EXPECT_NEAR(energies(sim, Vec3::Zero()).kinetic, 8.0, 1e-14);
  EXPECT_NEAR(balance.integrator_loss(energies(sim, Vec3::Zero()), sim.state().account), 0.0,
              1e-14);
}

// A run that goes on from a saved state has its accounts open already.
TEST(EnergyBalance, CountsFromItsOwnStart) {
  const Network net = make_net({{0, 0, 0}, {1, 0, 0}}, {{0, 1}});
  const std::vector<Body> none;
  State saved = initial_state(net, none);
  saved.account.prescribed_work = 100.0;
  saved.account.environment_loss = 30.0;
  Simulation sim(net, none, saved);
  sim.configure({}, {}, {});
  EnergyBalance balance;
  balance.begin(sim);
  EXPECT_EQ(balance.integrator_loss(energies(sim, Vec3::Zero()), sim.state().account), 0.0);
}

// Free fall at 1 g, then weightless, then at half of it sideways: no step of the loss at a change.
TEST(EnergyBalance, ChangeOfGravityIsNoLoss) {
  const Network net = make_net({{0, 0, 100}, {1, 0, 100}}, {{0, 1}});
  const std::vector<Body> none;
  Simulation sim = start(net, none, {Vec3(0, 0, -10), 0.0});
  EnergyBalance balance;
  balance.begin(sim);
  const auto loss = [&] {
    return balance.integrator_loss(energies(sim, balance.gravity()), sim.state().account);
  };
  IntegratorSpec midpoint;
  midpoint.method = Method::midpoint;  // falls exactly
  int k = 0;
  for (const Vec3& g : {Vec3(0, 0, -10), Vec3(0, 0, 0), Vec3(5, 0, 0)}) {
    sim.configure({g, 0.0}, midpoint, {});
    balance.see(sim);
    EXPECT_NEAR(loss(), 0.0, 1e-9);
    for (int n = 0; n < 10; ++n) {
      sim.advance(0.1 * ++k, {});
      balance.see(sim);
      EXPECT_NEAR(loss(), 0.0, 1e-9);
    }
  }
  EXPECT_NEAR(sim.state().v[0].z(), -10.0, 1e-9);
}

}  // namespace
}  // namespace retiarius

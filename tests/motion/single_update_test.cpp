// Linearly implicit steps: one Newton update each.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/motion/simulation.hpp"
#include "tests/motion/advance.hpp"
#include "tests/motion/flying_net.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;
using ::testing::HasSubstr;

const std::vector<Body> kNoBodies;

IntegratorSpec linearly_implicit(Newton newton = Newton::single) {
  IntegratorSpec spec;
  spec.newton = newton;
  return spec;
}

// A quadratic potential has nothing left to iterate: a hanging mass moves along its thread.
TEST(SingleUpdate, IsExactWhereForcesAreLinear) {
  Network net = chain({{0, 0, 0}, {0, 0, -1}}, thread_material(200.0, 1e-9));
  net.mass[1] = 2.0;
  Simulation single(net, kNoBodies, initial_state(net, kNoBodies));
  Simulation converged(net, kNoBodies, initial_state(net, kNoBodies));
  single.configure({{0, 0, -9.81}, 3.0}, linearly_implicit(), {});
  converged.configure({{0, 0, -9.81}, 3.0}, linearly_implicit(Newton::converged), {});
  for (int k = 1; k <= 50; ++k) {
    const StepReport report = single.advance(0.01 * k, hold(net.initial, {0}));
    converged.advance(0.01 * k, hold(net.initial, {0}));
    EXPECT_TRUE(report.single);
    EXPECT_EQ(report.iterations, 1);
    ASSERT_NEAR(single.state().x[1].z(), converged.state().x[1].z(), 1e-12);
    ASSERT_NEAR(single.state().v[1].z(), converged.state().v[1].z(), 1e-10);
    // The support is read from the model, not from a residual that converged.
    ASSERT_NEAR(single.state().support[0].z(), converged.state().support[0].z(), 1e-8);
  }
}

// Internal forces of the model cancel, and what supports do is in the account.
TEST(SingleUpdate, KeepsLinearMomentumToRoundOff) {
  const Network net = flying_net(Pattern::square, 3, true, 0.0, 0.02);
  for (const bool held : {false, true}) {
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure({{0, 0, -9.81}, 0.1}, linearly_implicit(), {});
    const Vec3 before = linear_momentum(sim);
    run(sim, 0.002, 100, held ? hold(net.initial, net.corners) : PrescribedMotion{});
    const Vec3 change = linear_momentum(sim) - before - sim.state().account.outside_impulse;
    EXPECT_LT(change.norm(), 1e-12 * momentum_scale(sim)) << held;
  }
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

// It differs from the converged scheme by a multiple of the step, as both do from the truth.
TEST(SingleUpdate, IsOfFirstOrder) {
  const Network net = flying_net(Pattern::square, 2, true, 0.0, 0.02);
  const auto end = [&](double h, Newton newton) {
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure({}, linearly_implicit(newton), {});
    run(sim, h, static_cast<int>(std::lround(0.064 / h)));
    return sim.state().x;
  };
  const std::vector<Vec3> truth = [&] {
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    IntegratorSpec spec;
    spec.method = Method::newmark;
    sim.configure({}, spec, {});
    run(sim, 1.25e-4, 512);
    return sim.state().x;
  }();
  const double coarse = farthest(end(1e-3, Newton::single), truth);
  const double fine = farthest(end(5e-4, Newton::single), truth);
  EXPECT_NEAR(coarse / fine, 2.0, 0.3);
}

std::string refusal(const Network& net, const IntegratorSpec& integrator, bool body,
                    const ContactSpec& contact) {
  BodySpec ball;
  ball.shape = ShapeKind::sphere;
  ball.radius = 0.1;
  ball.motion = BodyMotion::fixed;
  const std::vector<Body> bodies =
      body ? std::vector<Body>{build_body(ball, "")} : std::vector<Body>{};
  Simulation sim(net, bodies, initial_state(net, bodies));
  try {
    sim.configure({}, integrator, contact);
    return {};
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(SingleUpdate, IsRefusedWhereItWouldExplode) {
  const Network soft = flying_net(Pattern::square, 1, true, 0.0, 0.0);
  EXPECT_EQ(refusal(soft, linearly_implicit(), true, {}), "");
  EXPECT_THAT(
      refusal(flying_net(Pattern::square, 1, false, 0.0, 0.0), linearly_implicit(), false, {}),
      HasSubstr("needs threads that carry compression"));
  EXPECT_THAT(refusal(soft, linearly_implicit(), true, {ContactMethod::modified_mass, 0.1}),
              HasSubstr("needs contact.method = \"none\""));
  EXPECT_EQ(refusal(soft, linearly_implicit(), false, {ContactMethod::modified_mass, 0.1}), "");
  IntegratorSpec adaptive = linearly_implicit();
  adaptive.adaptive = true;
  EXPECT_THAT(refusal(soft, adaptive, false, {}), HasSubstr("needs adaptive = false"));
  IntegratorSpec newmark = linearly_implicit();
  newmark.method = Method::newmark;
  EXPECT_THAT(refusal(soft, newmark, false, {}), HasSubstr("needs method = \"implicit-euler\""));
}

}  // namespace
}  // namespace retiarius

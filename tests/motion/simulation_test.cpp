// Prescribed motion, reactions, halving and failure.
#include "retiarius/motion/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/motion/integrator.hpp"
#include "tests/motion/advance.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr Method kDynamic[] = {Method::implicit_euler, Method::newmark, Method::midpoint,
                               Method::generalised_alpha, Method::tr_bdf2};
const std::vector<Body> kNoBodies;

IntegratorSpec by(Method method) {
  IntegratorSpec spec;
  spec.method = method;
  return spec;
}

// A mass hung from a held node; environmental damping brings it to rest.
TEST(Support, CarriesTheWeightOfAHangingMass) {
  for (Method method : kDynamic) {
    Network net = chain({{0, 0, 0}, {0, 0, -1}}, thread_material(200.0, 1e-9));
    net.mass[1] = 2.0;
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure({{0, 0, -9.81}, 8.0}, by(method), {});
    run(sim, 0.02, 600, hold(net.initial, {0}));
    // Free vibration has decayed by e^(-4 * 12).
    EXPECT_NEAR(sim.state().support[0].z(), 2.0 * 9.81, 1e-6) << to_string(method);
    EXPECT_NEAR(sim.tensions()[0], 2.0 * 9.81, 1e-6) << to_string(method);
    EXPECT_NEAR(sim.state().x[1].z(), -(1.0 + 2.0 * 9.81 / 200.0), 1e-8) << to_string(method);
  }
}

// A held node of mass m accelerated uniformly: force m a, work 1/2 m v^2. The thread is slack.
TEST(Support, AcceleratesAMass) {
  const double m = 3.0, a = 2.0, h = 0.01;
  for (Method method : kDynamic) {
    Material material = thread_material(200.0, 1e-12);
    material.compression = false;
    Network net = chain({{0, 0, 0}, {0, 0, 1}}, material);
    net.segments[0].rest_length = 10.0;
    net.mass = {m, 1.0};
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure({}, by(method), {});
    const auto path = [&](double t) {
      return std::vector<Prescribed>{{0, {0.5 * a * t * t, 0, 0}, {a * t, 0, 0}}};
    };
    run(sim, h, 100, path,
        [&](int) { EXPECT_NEAR(sim.state().support[0].x(), m * a, 1e-9) << to_string(method); });
    EXPECT_NEAR(sim.state().x[0].x(), 0.5 * a, 1e-12);
    EXPECT_NEAR(sim.state().v[0].x(), a, 1e-12);
    EXPECT_NEAR(sim.state().account.prescribed_work, 0.5 * m * a * a, 1e-9) << to_string(method);
  }
}

TEST(Kick, BooksItsWorkAndImpulse) {
  const Network net = straight_chain(2, 2.0, thread_material(100.0, 1.0));
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, by(Method::midpoint), {});
  sim.kick(1, {0, 0, 4});  // 1 kg
  EXPECT_DOUBLE_EQ(sim.state().account.prescribed_work, 8.0);
  EXPECT_EQ(sim.state().account.outside_impulse, Vec3(0, 0, 4));
  EXPECT_EQ(sim.state().account.outside_angular_impulse, Vec3(1, 0, 0).cross(Vec3(0, 0, 4)));
}

// A stiff chain whose end is thrown: the whole step needs more iterations than it is given.
Network thrown_chain() {
  Material m = thread_material(5e4, 0.01);
  m.compression = false;
  Network net = straight_chain(20, 2.0, m);
  net.velocity[20] = {5, 30, 0};
  return net;
}

TEST(Halving, PassesWhereTheWholeStepFails) {
  const Network net = thrown_chain();
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator = by(Method::implicit_euler);
  integrator.max_iterations = 4;
  sim.configure({}, integrator, {});
  const StepReport report = sim.advance(0.05, hold(net.initial, {0}));
  EXPECT_GT(report.halvings, 0);
  EXPECT_DOUBLE_EQ(report.h, std::ldexp(0.05, -report.halvings));
  EXPECT_DOUBLE_EQ(sim.state().time, report.h);
  EXPECT_EQ(sim.state().step, 1);
  EXPECT_GT(report.iterations, 4);
}

// The same step with iterations enough: the line search copes with threads that snap taut.
TEST(Halving, IsNotNeededWithIterationsEnough) {
  const Network net = thrown_chain();
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator = by(Method::implicit_euler);
  integrator.max_iterations = 200;
  sim.configure({}, integrator, {});
  const StepReport report = sim.advance(0.05, hold(net.initial, {0}));
  EXPECT_EQ(report.halvings, 0);
  EXPECT_DOUBLE_EQ(sim.state().time, 0.05);
}

// With barriers the step after a cut one does not try the whole again.
TEST(Halving, IsRememberedWithBarriers) {
  const Network net = thrown_chain();
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator = by(Method::implicit_euler);
  integrator.max_iterations = 4;
  ContactSpec contact;
  contact.method = ContactMethod::barrier;
  integrator.step = 0.05;
  sim.configure({}, integrator, contact);
  const StepReport cut = sim.advance(0.05, hold(net.initial, {0}));
  ASSERT_GT(cut.halvings, 0);
  EXPECT_DOUBLE_EQ(sim.state().memory.next_step, cut.h);
  const StepReport next = sim.advance(0.05, hold(net.initial, {0}));
  EXPECT_LE(next.h, 1.0001 * cut.h);
  EXPECT_GT(next.halvings, 0);
}

TEST(Failure, NamesTimeNodeAndRemedyAndLeavesTheState) {
  const Network net = thrown_chain();
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator = by(Method::implicit_euler);
  integrator.max_iterations = 1;
  integrator.max_halvings = 2;
  sim.configure({}, integrator, {});
  const State before = sim.state();
  try {
    sim.advance(0.05, hold(net.initial, {0}));
    FAIL() << "one iteration cannot do";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("the step at time 0 s does not converge"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("even cut to 0.0125 s"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("no convergence within 1 iterations"));
    EXPECT_THAT(error.what(), ::testing::ContainsRegex("N, is at node [0-9]+ \\("));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("integrator.step"));
  }
  EXPECT_EQ(sim.state().time, before.time);
  EXPECT_EQ(sim.state().step, before.step);
  EXPECT_EQ(sim.state().x, before.x);
  EXPECT_EQ(sim.state().v, before.v);
}

// A straight tension-only thread at rest is at the very edge of slackness: a pull at its end must
// not be told from segment to segment, one an iteration (here more than 200 would be needed).
TEST(TensionOnly, ALongStraightThreadFeelsAPullAtOnce) {
  Material m = thread_material(5e4, 0.01);
  m.compression = false;
  Network net = straight_chain(300, 30.0, m);
  net.velocity[300] = {2, 30, 0};
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, by(Method::implicit_euler), {});
  const StepReport report = sim.advance(0.05, hold(net.initial, {0}));
  EXPECT_EQ(report.halvings, 0);
  EXPECT_LE(report.iterations, 40);
}

// NaN in a velocity: the run ends with an error, and the state is what it was.
TEST(Failure, NotANumberIsCaughtAndItsNodeNamed) {
  Network net = straight_chain(5, 1.0, thread_material(100.0, 0.1));
  net.velocity[3].x() = std::nan("");
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, by(Method::implicit_euler), {});
  try {
    sim.advance(0.01, {});
    FAIL() << "a position that is not a number was accepted";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("not finite"));
    // Node 3 and its neighbours: the first of them is named.
    EXPECT_THAT(error.what(), ::testing::HasSubstr("at node 2"));
  }
}

}  // namespace
}  // namespace retiarius

// What `auto` takes: by counts, for reasons that it tells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/family.hpp"
#include "benchmarks/flights.hpp"
#include "retiarius/motion/stable_step.hpp"
#include "tests/motion/advance.hpp"
#include "tests/motion/flying_net.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;
using ::testing::HasSubstr;

const std::vector<Body> kNoBodies;

// The net whose flight is timed, also with threads that push.
Network stiff_net(int segments, bool compression = false) {
  NetSpec spec = benchmarks::flight_net(segments);
  spec.thread.compression = compression;
  return build_network(spec);
}

IntegratorSpec automatic(double step) {
  IntegratorSpec spec;
  spec.method = Method::automatic;
  spec.step = step;
  return spec;
}

Choice chosen(const Network& net, const IntegratorSpec& spec, const ContactSpec& contact = {}) {
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, spec, contact);
  EXPECT_EQ(sim.integrator().method, sim.choice().method);
  return sim.choice();
}

// Explicit sub-steps of this flight take 0.7, 2.5 and 20 s of a core for each second; implicit
// Euler within the same 1 % of mouth area 5 s and more.
TEST(Choice, StiffNetsOfFewSegmentsFlyExplicitly) {
  for (const int segments : {2, 4, 10}) {
    const Choice choice = chosen(stiff_net(segments), automatic(0.005));
    EXPECT_EQ(choice.method, Method::explicit_differences) << choice.method_reason;
    EXPECT_THAT(choice.method_reason, HasSubstr("explicit sub-steps"));
    EXPECT_EQ(choice.solver_reason, "") << "nothing is solved for";
  }
}

// Where all threads carry compression, implicit Euler is as accurate as is asked in the step asked.
TEST(Choice, ThreadsThatPushAndSoftOnesGoImplicitly) {
  EXPECT_EQ(chosen(stiff_net(10, true), automatic(0.005)).method, Method::implicit_euler);
  const Choice soft = chosen(build_network(benchmarks::net_of({10, 9})), automatic(0.01));
  EXPECT_EQ(soft.method, Method::implicit_euler);
  EXPECT_THAT(soft.method_reason, HasSubstr("implicit Euler in steps of 0.01 s"));
}

TEST(Choice, ThreadsThatCannotPushAskForShorterImplicitSteps) {
  WorkCounts work = count_work(stiff_net(2));
  // 1,300 pieces, less four: corners have two segments as nodes inside a piece have, and count as
  // these.
  EXPECT_NEAR(work.crossing, 1300.0 / 1296.0 * 0.2 / std::sqrt(70e9 / 1390.0), 1e-12);
  EXPECT_LT(comparable_step(work, automatic(0.005)), 2e-4);
  EXPECT_EQ(comparable_step(work, automatic(1e-5)), 1e-5);
  EXPECT_EQ(comparable_step(count_work(stiff_net(2, true)), automatic(0.005)), 0.005);
}

TEST(Choice, WhatExplicitStepsCannotDoIsImplicit) {
  const Network net = stiff_net(2);
  ContactSpec barrier;
  barrier.method = ContactMethod::barrier;
  Choice choice = chosen(net, automatic(0.005), barrier);
  EXPECT_EQ(choice.method, Method::implicit_euler);
  EXPECT_EQ(choice.method_reason, "barriers need an implicit method");
  IntegratorSpec spec = automatic(0.005);
  spec.adaptive = true;
  choice = chosen(net, spec);
  EXPECT_EQ(choice.method, Method::implicit_euler);
  EXPECT_EQ(choice.method_reason, "steps are adaptive and threads carry no compression");
  choice = chosen(stiff_net(2, true), spec);
  EXPECT_EQ(choice.method, Method::tr_bdf2);
  spec = automatic(0.005);
  spec.newton = Newton::single;
  choice = chosen(stiff_net(2, true), spec);
  EXPECT_EQ(choice.method, Method::implicit_euler);
  EXPECT_EQ(choice.method_reason, "a single Newton update is asked for");
}

TEST(Choice, NamedMethodsStayAndNeedNoReason) {
  IntegratorSpec spec;
  spec.solver = Solver::direct;
  const Choice choice = chosen(stiff_net(2), spec);
  EXPECT_EQ(choice.method, Method::implicit_euler);
  EXPECT_EQ(choice.solver, Solver::direct);
  EXPECT_EQ(choice.method_reason + choice.solver_reason, "");
}

TEST(Choice, TellsWhySolversAreTaken) {
  EXPECT_THAT(chosen(stiff_net(2), IntegratorSpec{}).solver_reason, HasSubstr("seldom serve"));
  const Network soft = build_network(benchmarks::net_of({27, 0}));
  IntegratorSpec spec;
  EXPECT_EQ(chosen(soft, spec).solver, Solver::reuse);
  spec.step = 0.001;
  const Choice choice = chosen(soft, spec);
  EXPECT_EQ(choice.solver, Solver::pcg);
  EXPECT_THAT(choice.solver_reason, HasSubstr("conjugate gradients"));
}

// The same steps as by the method named, bit for bit.
TEST(Choice, StepsAsTheMethodTakenDoes) {
  const Network net = flying_net(Pattern::hexagon, 2, false, 1e-4, 0.0);
  std::vector<Vec3> ends[2];
  const Method method = chosen(net, automatic(0.001)).method;
  for (const Method m : {Method::automatic, method}) {
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    IntegratorSpec spec = automatic(0.001);
    spec.method = m;
    sim.configure({{0, 0, -9.81}, 0.1}, spec, {});
    run(sim, 0.001, 5);
    ends[m == Method::automatic ? 0 : 1] = sim.state().x;
  }
  EXPECT_EQ(ends[0], ends[1]);
}

// Costs go as the counts do.
TEST(Choice, CostsFollowTheCounts) {
  WorkCounts work = count_work(stiff_net(4));
  work.factor_flops = 1e6;
  work.factor_entries = 1e5;
  const IntegratorSpec spec = automatic(0.005);
  WorkCounts shorter = work;
  shorter.stable_step *= 0.5;
  EXPECT_NEAR(explicit_cost(shorter, spec) / explicit_cost(work, spec), 2.0, 1e-12);
  WorkCounts bends = work;
  bends.joints = work.nodes;
  EXPECT_GT(explicit_cost(bends, spec), 2.0 * explicit_cost(work, spec));
  EXPECT_GT(implicit_cost(work, spec, 1e-4), implicit_cost(work, spec, 1e-3));
  WorkCounts dense = work;
  dense.factor_flops *= 1000.0;
  EXPECT_GT(implicit_cost(dense, spec, 1e-3), 2.0 * implicit_cost(work, spec, 1e-3));
}

}  // namespace
}  // namespace retiarius

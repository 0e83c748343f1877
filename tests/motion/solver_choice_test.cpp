// Which linear solver a simulation takes, and that all of them step alike.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/family.hpp"
#include "retiarius/base/parallel.hpp"
#include "tests/motion/advance.hpp"
#include "tests/motion/flying_net.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

const std::vector<Body> kNoBodies;

std::vector<Vec3> fallen(const Network& net, std::unique_ptr<LinearSolver> solver, Solver way,
                         double h) {
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies), {}, std::move(solver));
  IntegratorSpec spec;
  spec.solver = way;
  sim.configure({{0, 0, -9.81}, 0.1}, spec, {});
  run(sim, h, 20, hold(net.initial, net.corners));
  return sim.state().x;
}

TEST(SolverChoice, AllSolversStepAlike) {
  for (const int segments : {1, 5}) {
    const Network net = flying_net(Pattern::hexagon, segments, true, 0.0, 0.02);
    const auto expected = fallen(net, make_reference_solver(), Solver::direct, 0.001);
    for (const Solver way : {Solver::direct, Solver::reuse, Solver::pcg}) {
      for (const auto make : {make_multifrontal_solver, make_piece_solver, make_net_solver}) {
        const auto x = fallen(net, make(), way, 0.001);
        for (std::size_t i = 0; i < x.size(); ++i)
          ASSERT_LT((x[i] - expected[i]).norm(), 1e-7) << segments;
      }
    }
  }
}

TEST(SolverChoice, ThreadsDoNotChangeABit) {
  const Network net = build_network(benchmarks::net_of({12, 3}));
  for (const Solver way : {Solver::automatic, Solver::pcg}) {
    set_threads(1);
    const auto expected = fallen(net, make_net_solver(), way, 0.002);
    for (const int count : {2, 4}) {
      set_threads(count);
      EXPECT_EQ(fallen(net, make_net_solver(), way, 0.002), expected);
    }
    set_threads(1);
  }
}

std::string taken(const benchmarks::Member& member, double h, Solver way = Solver::automatic) {
  const Network net = build_network(benchmarks::net_of(member));
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec spec;
  spec.step = h;
  spec.solver = way;
  sim.configure({}, spec, {});
  return std::string(sim.solver().name());
}

TEST(SolverChoice, FollowsTheCounts) {
  EXPECT_EQ(taken({27, 0}, 0.001), "pcg");          // waves go less than a segment a step
  EXPECT_EQ(taken({27, 0}, 0.01), "multifrontal");  // ... nine segments
  EXPECT_EQ(taken({10, 3}, 0.001), "pieces");       // a cheap factor
  EXPECT_EQ(taken({5, 9, false}, 0.01), "pieces");
  EXPECT_EQ(taken({5, 9, false}, 0.01, Solver::pcg), "pcg");
}

}  // namespace
}  // namespace retiarius

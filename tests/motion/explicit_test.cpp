// The explicit integrator: order, energy, momentum, against the laws and against exact answers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/motion/stable_step.hpp"
#include "tests/motion/advance.hpp"
#include "tests/motion/flying_net.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

const std::vector<Body> kNoBodies;

IntegratorSpec explicitly(double substep = 0.0) {
  IntegratorSpec spec;
  spec.method = Method::explicit_differences;
  spec.substep = substep;
  return spec;
}

// A law as it is: its presence alone takes the simulation off its fast path.
std::unique_ptr<Law> same(std::unique_ptr<Law> law) { return law; }

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum);
}

// The same motion by the sweep in vectors and by the laws' own gradients.
struct TwoWays {
  Simulation fast, slow;
  TwoWays(const Network& net, double substep, int steps, const PrescribedMotion& motion)
      : fast(net, kNoBodies, initial_state(net, kNoBodies)),
        slow(net, kNoBodies, initial_state(net, kNoBodies), same) {
    for (Simulation* sim : {&fast, &slow}) {
      sim->configure({{1, 2, -9.81}, 0.4}, explicitly(substep), {});
      run(*sim, 1e-3, steps, motion, [this](int) {
        for (const double t : fast.tensions()) lowest = std::min(lowest, t);
      });
    }
  }
  double apart() const { return distance(fast.state().x, slow.state().x); }
  double lowest = kInfinity;  // tension, N
};

// Taut beyond rounding, which would else decide where tension-only threads start, in a motion that
// is smooth at first, since rough ones draw any two computations apart.
Network taut_net(bool compression, double tau, double spin) {
  Network net = flying_net(Pattern::hexagon, 3, compression, tau, 0.0);
  for (std::size_t i = 0; i < net.initial.size(); ++i) {
    net.velocity[i] = Vec3(0.3, -0.2, 3) + spin * Vec3(1, 2, 3).cross(net.initial[i]);
    net.initial[i] *= 1.01;
  }
  return net;
}

// Some of whose nodes are held.
PrescribedMotion caught(Network& net) {
  const std::vector<Index> held{3, 40, net.corners[0]};
  for (const Index node : held) net.velocity[node] = Vec3::Zero();
  return hold(net.initial, held);
}

// The sweep and the laws take velocities for the damping differently, both to second order: they
// draw together fourfold with each halving of the sub-step. So they do with tension-only threads,
// too, as long as the force is a Lipschitz function of the motion: without material damping, or
// where all stays taut. Beyond that see the next test.
TEST(ExplicitSweep, MovesAsTheLawsDo) {
  for (const bool compression : {true, false}) {
    for (const double tau : {0.0, 1e-4}) {
      const bool kinked = !compression && tau > 0.0;
      Network net = taut_net(compression, tau, 1.0);
      const PrescribedMotion motion = kinked ? PrescribedMotion{} : caught(net);
      const int steps = kinked ? 2 : 20;
      const TwoWays a(net, 2e-5, steps, motion), b(net, 1e-5, steps, motion);
      EXPECT_LT(a.apart(), 1e-7) << compression << " " << tau;
      EXPECT_NEAR(a.apart() / b.apart(), 4.0, 0.2) << compression << " " << tau;
      EXPECT_TRUE(!kinked || b.lowest > 0.0) << b.lowest;
    }
  }
}

// Where a damped tension-only thread becomes taut at the rate u', its tension jumps by k tau u'.
// The sweep's backward differences book that jump exactly wherever it falls in a sub-step: if the
// thread has been taut for the share t of one, their impulse over that sub-step and the next is k
// tau u' h (3/2 t + 3/2 - t/2) = k tau u' h (t + 3/2), as it should be. So the sweep keeps its
// second order. The laws take the rate from the velocities and give the whole jump from the first
// sub-step on, k tau u' h (1 + 1): an error of up to k tau u' h / 2, which falls with h, unevenly.
// At a node of mass m with omega^2 = 4 k / m it swings with at most h tau u' omega / 8.
TEST(ExplicitSweep, KeepsItsOrderWhereDampedThreadsBecomeTaut) {
  const double tau = 1e-4, approach = 3.0;
  Network net = taut_net(false, tau, 1.0);
  const PrescribedMotion motion = caught(net);
  const double omega = 2.0 / stable_explicit_step(taut_net(true, 0.0, 1.0)).step;
  std::vector<std::vector<Vec3>> fast;
  for (const double h : {5e-6, 2.5e-6, 1.25e-6}) {
    const TwoWays both(net, h, 20, motion);
    EXPECT_EQ(both.lowest, 0.0);
    EXPECT_LT(both.apart(), h * tau * approach * omega / 8.0) << h;
    fast.push_back(both.fast.state().x);
  }
  EXPECT_NEAR(distance(fast[0], fast[1]) / distance(fast[1], fast[2]), 4.0, 0.4);
}

// What is booked, and what supports bear, are the same too.
TEST(ExplicitSweep, BooksAsTheLawsDo) {
  for (const bool compression : {true, false}) {
    for (const double tau : {0.0, 1e-4}) {
      Network net = taut_net(compression, tau, 1.0);
      const TwoWays both(net, 1e-5, 20, caught(net));
      EXPECT_GT(distance(both.fast.state().x, net.initial), 0.1);
      const Account &a = both.fast.state().account, &b = both.slow.state().account;
      EXPECT_NEAR(a.environment_loss, b.environment_loss, 1e-4 * b.environment_loss);
      EXPECT_NEAR(a.material_loss, b.material_loss, 0.02 * b.material_loss);
      EXPECT_NEAR(a.prescribed_work, b.prescribed_work, 1e-4 * std::abs(b.prescribed_work));
      EXPECT_LT((a.outside_impulse - b.outside_impulse).norm(), 1e-4 * b.outside_impulse.norm());
      const Vec3 &f = both.fast.state().support[3], &g = both.slow.state().support[3];
      EXPECT_LT((f - g).norm(), 1e-3 * g.norm());
    }
  }
}

TEST(ExplicitSweep, IsTheSameWithAllKernels) {
  const Network net = flying_net(Pattern::hexagon, 3, false, 1e-4, 0.0);
  std::vector<std::vector<Vec3>> ends;
  for (const std::string_view kernels : available_kernels()) {
    set_kernels(kernels);
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure({{0, 0, -9.81}, 0.1}, explicitly(), {});
    run(sim, 1e-3, 10);
    ends.push_back(sim.state().x);
  }
  set_kernels("auto");
  for (const auto& x : ends) EXPECT_LT(distance(x, ends.front()), 1e-11);
}

// From runs at h, h/2, h/4, and against the midpoint rule.
TEST(ExplicitOrder, IsTwoInTheSubstep) {
  for (const double tau : {0.0, 0.02}) {
    for (const double bending : {0.0, 0.3}) {
      Material m = thread_material(60.0, 0.1);
      m.damping = tau;
      if (bending > 0.0) m.bending = Bending::bounded;
      m.bending_stiffness = bending;
      const Network net = straight_chain(6, 1.5, m);
      const auto end_of = [&](const IntegratorSpec& integrator, double h) {
        Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
        sim.configure({{0, 0, -4}, 0.5}, integrator, {});
        run(sim, h, static_cast<int>(std::lround(0.5 / h)), hold(net.initial, {0}));
        return sim.state().x;
      };
      const auto a = end_of(explicitly(4e-4), 0.05), b = end_of(explicitly(2e-4), 0.05),
                 c = end_of(explicitly(1e-4), 0.05);
      EXPECT_NEAR(std::log2(distance(a, b) / distance(b, c)), 2.0, 0.15) << tau << " " << bending;
      IntegratorSpec midpoint;
      midpoint.method = Method::midpoint;
      midpoint.tolerance = 1e-12;
      EXPECT_LT(distance(c, end_of(midpoint, 2e-4)), 1e-5) << tau << " " << bending;
    }
  }
}

// Two masses on a spring along it: (2/h) asin(omega h / 2), and an energy that stays within
// (omega h)^2 / 4 for ever.
TEST(ExplicitOscillator, HasTheSchemesFrequencyAndKeepsItsEnergy) {
  Network net = chain({{0, 0, 0}, {1, 0, 0}}, thread_material(100.0, 1e-12), 0.5);
  net.velocity = {{-1e-3, 0, 0}, {1e-3, 0, 0}};
  const double omega = 20.0, h = 0.02;
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, explicitly(h), {});
  const double before = mechanical_energy(sim);
  const double seen = 2.0 / h * std::asin(0.5 * omega * h);
  double worst = 0.0, lowest = kInfinity, highest = 0.0;
  run(sim, h, 20000, {}, [&](int k) {
    const double u = sim.state().x[1].x() - sim.state().x[0].x() - 1.0;
    // Half kicks at the ends: v0 is the scheme's velocity at the node, u = A sin(k seen h).
    const double amplitude = 2e-3 * h / std::sin(seen * h);
    if (k <= 1000) worst = std::max(worst, std::abs(u - amplitude * std::sin(seen * h * k)));
    lowest = std::min(lowest, mechanical_energy(sim));
    highest = std::max(highest, mechanical_energy(sim));
  });
  EXPECT_LT(worst, 1e-10);
  EXPECT_GT(lowest, before * (1.0 - 1e-9));
  EXPECT_LT(highest, before * (1.0 + 0.3 * omega * omega * h * h));
}

TEST(ExplicitEnergy, OfAFlightWithoutDampingDoesNotDrift) {
  const Network net = flying_net(Pattern::hexagon, 3, true, 0.0, 0.0);
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, explicitly(), {});
  const double before = mechanical_energy(sim);
  double worst[4] = {};  // of each quarter of the time
  run(sim, 2e-3, 2000, {}, [&](int k) {
    double& own = worst[(k - 1) / 500];
    own = std::max(own, std::abs(mechanical_energy(sim) / before - 1.0));
  });
  for (const double w : worst) EXPECT_LT(w, 0.005);
  // The first quarter ends with the motion spread over all waves.
  EXPECT_LT(worst[3], 1.3 * std::max(worst[1], worst[2]));
}

// The account explains the energy's fall; its remainder is of second order.
TEST(ExplicitEnergy, AccountClosesToSecondOrder) {
  const Network net = flying_net(Pattern::hexagon, 3, true, 1e-3, 0.0);
  double remainder[2], lost = 0.0;
  for (int k = 0; k < 2; ++k) {
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure({{0, 0, -9.81}, 0.3}, explicitly(1e-4 / (1 << k)), {});
    const double before = mechanical_energy(sim);
    run(sim, 0.01, 10);
    lost = before - mechanical_energy(sim);
    remainder[k] = lost - accounted_loss(sim.state());
  }
  EXPECT_LT(std::abs(remainder[1]), 1e-3 * lost);
  EXPECT_GT(lost, 0.1);
  EXPECT_NEAR(remainder[0] / remainder[1], 4.0, 1.2) << remainder[0];
}

TEST(ExplicitMomentum, IsKeptAndBookedToRoundOff) {
  for (const bool wrapped : {false, true}) {
    for (const double bending : {0.0, 0.05}) {
      const Network net = flying_net(Pattern::hexagon, 3, false, 1e-4, bending);
      Simulation sim(net, kNoBodies, initial_state(net, kNoBodies), wrapped ? same : LawWrapper{});
      sim.configure({{1, 2, -9.81}, 0.4}, explicitly(), {});
      sim.kick(3, {1, 2, 3});
      const Vec3 before = linear_momentum(sim) - sim.state().account.outside_impulse;
      run(sim, 0.002, 20, hold(net.initial, {net.corners[0], net.corners[2]}));
      const Vec3 after = linear_momentum(sim) - sim.state().account.outside_impulse;
      EXPECT_LT((after - before).norm(), 1e-11 * momentum_scale(sim)) << wrapped << bending;
    }
  }
}

// A node that is drawn along x = t^2: the support does the work that the net gets.
TEST(ExplicitMotion, FollowsPrescribedWaysAndBooksTheirWork) {
  const Network net = straight_chain(4, 1.0, thread_material(200.0, 0.1), Vec3::UnitX());
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, explicitly(1e-4), {});
  const PrescribedMotion way = [&](double t) {
    return std::vector<Prescribed>{{4, Vec3(1.0 + t * t, 0, 0), Vec3(2.0 * t, 0, 0)}};
  };
  run(sim, 0.01, 50, way);
  EXPECT_DOUBLE_EQ(sim.state().x[4].x(), 1.25);
  EXPECT_DOUBLE_EQ(sim.state().v[4].x(), 1.0);
  const double gained = mechanical_energy(sim);
  EXPECT_NEAR(sim.state().account.prescribed_work, gained, 1e-4 * gained);
}

// A thread whose end is drawn away at speed v: the plateau EA v / c behind the front.
TEST(ExplicitWave, CarriesEaVOverC) {
  const double stiffness = 1e4, line = 0.01, v = 1.0;
  Material m = thread_material(stiffness, line);
  m.damping = 2e-5;
  m.compression = false;
  const Network net = straight_chain(200, 10.0, m, Vec3::UnitX());
  const double c = std::sqrt(stiffness / line);
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, explicitly(), {});
  const PrescribedMotion pull = [&](double t) {
    return std::vector<Prescribed>{{0, Vec3(-v * t, 0, 0), Vec3(-v, 0, 0)}};
  };
  const double time = 6.0 / c;  // the front is at 6 m
  run(sim, time / 20.0, 20, pull);
  double mean = 0.0;
  for (int k = 10; k < 100; ++k) mean += sim.tensions()[k] / 90.0;
  EXPECT_NEAR(mean, stiffness * v / c, 0.01 * stiffness * v / c);
  EXPECT_NEAR(sim.tensions()[180], 0.0, 1e-6);
}

TEST(ExplicitSubsteps, AreWholeFractionsBelowTheStableStep) {
  const Network net = flying_net(Pattern::hexagon, 3, false, 1e-4, 0.0);
  const double stable = stable_explicit_step(net).step;
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, explicitly(), {});
  const StepReport report = sim.advance(1e-3, {});
  EXPECT_EQ(report.substeps, static_cast<int>(std::ceil(1e-3 / (0.9 * stable))));
  EXPECT_EQ(report.iterations, 0);
  EXPECT_DOUBLE_EQ(report.h, 1e-3);
  EXPECT_EQ(explicit_substeps(stable_explicit_step(net).step, explicitly(1e-6), 1e-3), 1000);
}

// One spring with damping: h^2 omega^2 + 4 h omega^2 tau = 4, from the scheme's amplification -1.
TEST(ExplicitSubsteps, TheBoundKnowsMaterialDamping) {
  Material m = thread_material(100.0, 1e-12);
  const Network plain = chain({{0, 0, 0}, {1, 0, 0}}, m, 0.5);
  EXPECT_NEAR(stable_explicit_step(plain).step, 2.0 / 20.0, 1e-9);
  m.damping = 0.02;
  const Network damped = chain({{0, 0, 0}, {1, 0, 0}}, m, 0.5);
  const double h = stable_explicit_step(damped).step;
  EXPECT_NEAR(400.0 * h * h + 4.0 * h * 400.0 * 0.02, 4.0, 1e-7);
}

TEST(ExplicitFailure, NamesNodeAndRemedy) {
  Network net = straight_chain(3, 1.0, thread_material(100.0, 0.1));
  net.velocity[2] = Vec3(0, 1e308, 0);
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({}, explicitly(), {});
  try {
    run(sim, 0.1, 100);
    FAIL() << "no error";
  } catch (const RunError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("has lost node"));
    EXPECT_THAT(e.what(), ::testing::HasSubstr("integrator.substep"));
  }
  EXPECT_EQ(explicit_substeps(stable_explicit_step(net).step, explicitly(), 1e-6), 1);
  EXPECT_THROW(explicit_substeps(stable_explicit_step(net).step, explicitly(1e-12), 1.0), RunError);
}

}  // namespace
}  // namespace retiarius

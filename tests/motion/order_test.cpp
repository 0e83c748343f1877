// Measured orders of convergence, and what each integrator does to energy and momentum.
#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/motion/advance.hpp"
#include "tests/motion/flying_net.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr Method kDynamic[] = {Method::implicit_euler, Method::newmark, Method::midpoint,
                               Method::generalised_alpha, Method::tr_bdf2};
const std::vector<Body> kNoBodies;

struct Problem {
  const char* name;
  Network net;
  EnvironmentSpec environment;
  std::vector<Index> held;
  double time;  // s
  int steps;    // of the coarsest of three runs
};

// End positions with 2^level times the coarsest number of steps.
std::vector<Vec3> end_of(const Problem& p, Method method, int steps) {
  Simulation sim(p.net, kNoBodies, initial_state(p.net, kNoBodies));
  IntegratorSpec integrator;
  integrator.method = method;
  integrator.tolerance = 1e-12;
  sim.configure(p.environment, integrator, {});
  run(sim, p.time / steps, steps, hold(p.net.initial, p.held));
  return sim.state().x;
}

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum);
}

// A pendulum of one soft segment that swings and stretches.
Problem pendulum(double tau, double mu) {
  Material m = thread_material(40.0, 0.01);
  m.damping = tau;
  Problem p{"pendulum", chain({{0, 0, 0}, {1, 0, 0}}, m, 0.2), {{0, 0, -9.81}, mu}, {0}, 0.8, 160};
  return p;
}

// Three free nodes that turn and stretch.
Problem free_chain(double tau) {
  Material m = thread_material(30.0, 0.05);
  m.damping = tau;
  Problem p{"free chain", chain({{0, 0, 0}, {1, 0, 0}, {2, 0.3, 0}}, m, 0.1), {}, {}, 1.0, 400};
  p.net.velocity = {{0, 1, 0.5}, {0.3, 0, 0}, {0.2, -1.5, 0.4}};
  return p;
}

// A soft chain with bending that oscillates between held ends.
Problem bending_chain(double tau, double mu) {
  Material m = thread_material(60.0, 0.1);
  m.bending = Bending::bounded;
  m.bending_stiffness = 0.3;
  m.damping = tau;
  Problem p{"bending chain", straight_chain(6, 1.5, m), {{0, 0, -4}, mu}, {0}, 0.5, 200};
  return p;
}

// From runs at h, h/2, h/4: log2 of the ratio of the differences, whose errors go as h^order. The
// next term of the error moves it by a few per cent at these steps.
TEST(Order, IsOneForImplicitEulerAndTwoForTheOthers) {
  const std::vector<Problem> problems = {pendulum(0.0, 0.0),      pendulum(0.02, 0.5),
                                         free_chain(0.0),         free_chain(0.05),
                                         bending_chain(0.0, 0.0), bending_chain(0.01, 0.5)};
  for (const Problem& p : problems) {
    for (Method method : kDynamic) {
      const std::vector<Vec3> a = end_of(p, method, 2 * p.steps);
      const std::vector<Vec3> b = end_of(p, method, 4 * p.steps);
      const std::vector<Vec3> c = end_of(p, method, 8 * p.steps);
      const double order = std::log2(distance(a, b) / distance(b, c));
      const double wanted = method == Method::implicit_euler ? 1.0 : 2.0;
      EXPECT_NEAR(order, wanted, 0.12)
          << p.name << " by " << to_string(method) << ", tau " << p.net.materials[0].damping;
      RecordProperty(std::string(p.name) + " " + to_string(method), std::to_string(order));
      // All methods go to one limit.
      EXPECT_LT(distance(c, end_of(p, Method::midpoint, 16 * p.steps)),
                method == Method::implicit_euler ? 0.05 : 1e-3)
          << p.name << " by " << to_string(method);
    }
  }
}

double energy_after(const Network& net, Method method, double h, int steps,
                    const EnvironmentSpec& environment = {}) {
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator;
  integrator.method = method;
  integrator.tolerance = 1e-12;
  sim.configure(environment, integrator, {});
  const double before = mechanical_energy(sim);
  run(sim, h, steps);
  return mechanical_energy(sim) / before;
}

// Two masses on a spring that move along it only: linear. Newmark's trapezoid and midpoint conserve
// the energy of a linear oscillator exactly; implicit Euler divides its square root by
// sqrt(1 + (omega h)^2) each step.
TEST(Energy, OfALinearOscillator) {
  Network net = chain({{0, 0, 0}, {1, 0, 0}}, thread_material(100.0, 1e-12), 0.5);
  net.velocity = {{-1, 0, 0}, {1, 0, 0}};
  const double h = 0.01, omega = std::sqrt(100.0 / 0.25);
  EXPECT_NEAR(energy_after(net, Method::newmark, h, 500), 1.0, 1e-10);
  EXPECT_NEAR(energy_after(net, Method::midpoint, h, 500), 1.0, 1e-10);
  const double kept = std::pow(1.0 + omega * omega * h * h, -100.0);
  EXPECT_NEAR(energy_after(net, Method::implicit_euler, h, 100) / kept, 1.0, 1e-7);
}

// What a convex problem loses in implicit Euler is half of m |dv|^2 and a Bregman distance: never
// negative, but for the round-off of energies of some 10 J and Newton's tolerance.
TEST(Energy, ImplicitEulersOwnLossIsNeverNegativeForTensionOnlyNets) {
  for (double tau : {0.0, 1e-3}) {
    const Network net = flying_net(Pattern::square, 2, false, tau, 0.0);
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    IntegratorSpec integrator;
    sim.configure({{0, 0, -9.81}, 0.2}, integrator, {});
    double before = mechanical_energy(sim) + accounted_loss(sim.state());
    double worst = 0.0, total = 0.0;
    run(sim, 0.005, 200, {}, [&](int) {
      const double after = mechanical_energy(sim) + accounted_loss(sim.state());
      worst = std::min(worst, before - after);
      total += before - after;
      before = after;
    });
    EXPECT_GT(worst, -1e-9) << "tau " << tau;
    EXPECT_GT(total, 1e-3);
    EXPECT_GE(sim.state().account.environment_loss, 0.0);
    EXPECT_GE(sim.state().account.material_loss, tau > 0.0 ? 1e-6 : 0.0);
  }
}

// With damping the account explains the energy's fall; the remainder is the integrator's, of second
// order: it falls about fourfold as h is halved, and is small.
TEST(Energy, AccountClosesToSecondOrder) {
  const Network net = flying_net(Pattern::square, 2, true, 2e-3, 0.05);
  for (Method method :
       {Method::newmark, Method::midpoint, Method::generalised_alpha, Method::tr_bdf2}) {
    double remainder[2];
    double lost = 0.0;
    for (int k = 0; k < 2; ++k) {
      Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
      IntegratorSpec integrator;
      integrator.method = method;
      sim.configure({{0, 0, -9.81}, 0.3}, integrator, {});
      const double before = mechanical_energy(sim);
      const int steps = 400 << k;
      run(sim, 0.2 / steps, steps);
      lost = before - mechanical_energy(sim);
      remainder[k] = lost - accounted_loss(sim.state());
    }
    EXPECT_LT(std::abs(remainder[1]), 1e-3 * lost) << to_string(method);
    EXPECT_NEAR(remainder[0] / remainder[1], 4.0, 1.2) << to_string(method) << " " << remainder[0];
  }
}

// Round-off of 81 nodes and 300 steps, even when Newton stops early.
TEST(Momentum, LinearIsKeptToRoundOffWithALooseTolerance) {
  for (bool compression : {true, false}) {
    const Network net = flying_net(Pattern::square, 2, compression, 1e-3, 0.05);
    for (Method method : kDynamic) {
      for (double tolerance : {1e-2, 1e-8}) {
        Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
        IntegratorSpec integrator;
        integrator.method = method;
        integrator.tolerance = tolerance;
        sim.configure({}, integrator, {});
        const Vec3 before = linear_momentum(sim);
        const double scale = momentum_scale(sim);
        run(sim, 0.002, 300);
        EXPECT_LT((linear_momentum(sim) - before).norm(), 1e-12 * scale)
            << to_string(method) << " tolerance " << tolerance;
      }
    }
  }
}

TEST(Momentum, AngularIsKeptByMidpointWithStretchingAndBending) {
  const Network net = flying_net(Pattern::square, 2, true, 1e-3, 0.05);
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator;
  integrator.method = Method::midpoint;
  integrator.tolerance = 1e-11;
  sim.configure({}, integrator, {});
  const Vec3 before = angular_momentum(sim);
  run(sim, 0.002, 200);
  EXPECT_LT((angular_momentum(sim) - before).norm(), 1e-12 * before.norm());
}

// Gravity, damping and supports: what they gave is in the account.
TEST(Momentum, OutsideImpulsesAreBooked) {
  const Network net = flying_net(Pattern::square, 2, true, 1e-3, 0.05);
  for (Method method : kDynamic) {
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    IntegratorSpec integrator;
    integrator.method = method;
    sim.configure({{1, 2, -9.81}, 0.4}, integrator, {});
    sim.kick(3, {1, 2, 3});
    const Vec3 before = linear_momentum(sim) - sim.state().account.outside_impulse;
    const double scale = momentum_scale(sim);
    run(sim, 0.002, 100, hold(net.initial, {net.corners[0], net.corners[2]}));
    const Vec3 after = linear_momentum(sim) - sim.state().account.outside_impulse;
    EXPECT_LT((after - before).norm(), 1e-12 * scale) << to_string(method);
  }
}

}  // namespace
}  // namespace retiarius

// Static equilibria and slow references: catenary, heavy cantilever, cantilever vibration.
#include <tuple>

#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/motion/integrator.hpp"
#include "tests/motion/advance.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

const std::vector<Body> kNoBodies;

State equilibrium(const Network& net, const Vec3& gravity, const std::vector<Prescribed>& held) {
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator;
  integrator.method = Method::static_solve;
  integrator.max_iterations = 200;
  sim.configure({gravity, 0.0}, integrator, {});
  sim.solve_static(held);
  return sim.state();
}

// The elastic line under its own weight: extension w (L - s) / EA, summed over lumped masses.
TEST(Static, HangingChainStretchesUnderItsWeight) {
  const int n = 20;
  const double ea = 50.0, line = 0.2, g = 9.81, length = 2.0;
  const Network net = straight_chain(n, length, thread_material(ea, line), -Vec3::UnitZ());
  const State s = equilibrium(net, {0, 0, -g}, held_at(net.initial, {0}));
  // Half masses at the ends make the discrete sum the trapezoid's, exact for a linear tension.
  EXPECT_NEAR(s.x[n].z(), -(length + 0.5 * line * g * length * length / ea), 1e-9);
  EXPECT_NEAR(s.support[0].z(), line * g * length, 1e-9);
  EXPECT_NEAR(s.support[0].x(), 0.0, 1e-9);
}

// Inextensible catenary of length 1 (span/L, sag/L, H/(w L)): computed independently. 200 chords of
// EA 1e7 w L differ by 1/n^2-terms of some 1e-5.
TEST(Static, CatenarySagAndTension) {
  const std::vector<std::tuple<double, double, double>> wanted = {
      {0.9, 0.19070900, 0.56009438}, {0.5, 0.39819418, 0.11482011}, {0.3, 0.45245383, 0.05004437}};
  const int n = 200;
  for (const auto& [span, sag, pull] : wanted) {
    Network net = straight_chain(n, 1.0, thread_material(1e6, 0.1));
    // Starts as a V of the right length.
    const double deep = 0.5 * std::sqrt(1.0 - span * span);
    for (int k = 0; k <= n; ++k) {
      const double s = static_cast<double>(k) / n;
      net.initial[k] = {span * s, 0.0, -deep * (1.0 - std::abs(2.0 * s - 1.0))};
    }
    const State s = equilibrium(net, {0, 0, -10}, held_at(net.initial, {0, n}));
    const double weight = 0.1 * 10.0;
    EXPECT_NEAR(s.x[n / 2].z(), -sag, 5e-5) << span;
    EXPECT_NEAR(s.support[n].x(), pull * weight, 2e-4 * weight) << span;
    // The residual's floor is 64 eps EA = 1.4e-8 N a node.
    EXPECT_NEAR(s.support[n].z(), 0.5 * weight, 2e-6 * weight) << span;
  }
}

// A flat net without strain has no stiffness across its plane; the relaxation finds its sag.
TEST(Static, FlatUnstrainedNetFindsItsSag) {
  const int n = 2;
  const double ea = 100.0, load = 1.0;
  const Network net = straight_chain(n, 2.0, thread_material(ea, load / 10.0));
  const State s = equilibrium(net, {0, 0, -10}, held_at(net.initial, {0, n}));
  // One free node of weight P = 1 N between two segments: 2 T sin = P, T = EA (1/cos - 1).
  double sag = 0.1;
  for (int k = 0; k < 100; ++k) {
    const double l = std::hypot(1.0, sag);
    const double f = 2.0 * ea * (l - 1.0) * sag / l - 1.0;
    const double df = 2.0 * ea * (1.0 - 1.0 / (l * l * l));
    sag -= f / df;
  }
  EXPECT_NEAR(s.x[1].z(), -sag, 1e-9);
}

TEST(Static, AnUnheldNetIsRefused) {
  const Network net = straight_chain(2, 2.0, thread_material(100.0, 0.1));
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator;
  integrator.method = Method::static_solve;
  sim.configure({{0, 0, -10}, 0.0}, integrator, {});
  EXPECT_THROW(sim.solve_static({}), RunError);
}

Network cantilever(Bending kind, double length, double young, int nodes) {
  const double r = 1e-3;
  Material m = thread_material(young * kPi * r * r, 1000.0 * kPi * r * r);
  m.bending = kind;
  m.bending_stiffness = young * kPi * std::pow(r, 4) / 4.0;
  return straight_chain(nodes - 1, length, m);
}

// Deflection of the tip of a heavy cantilever of 50 nodes, two of them clamped, beta = 4 g
// (L 1 m, E 1 GPa, r0 1 mm, rho 1000): computed independently.
TEST(Static, HeavyCantilever) {
  const std::vector<std::tuple<double, double, double>> wanted = {
      {0.1, 0.011994, 0.011994}, {0.5, 0.059800, 0.059799}, {1.0, 0.118570, 0.118567},
      {4.0, 0.411314, 0.411210}, {8.0, 0.625308, 0.625014}, {32.0, 0.866901, 0.866320}};
  for (const auto& [beta, bounded, tangent] : wanted) {
    for (Bending kind : {Bending::bounded, Bending::tangent}) {
      const Network net = cantilever(kind, 1.0, 1e9, 50);
      const State s = equilibrium(net, {0, 0, -beta / 4.0}, held_at(net.initial, {0, 1}));
      EXPECT_NEAR(-s.x[49].z(), kind == Bending::bounded ? bounded : tangent, 1e-5)
          << "beta " << beta << (kind == Bending::bounded ? " bounded" : " tangent");
    }
  }
}

// Minima of the tip of a vibrating cantilever (L 0.1 m, E 10 MPa, g 10, N = 50), computed
// independently.
std::vector<double> tip_minima(Method method, double h, double time) {
  const Network net = cantilever(Bending::bounded, 0.1, 1e7, 50);
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  IntegratorSpec integrator;
  integrator.method = method;
  sim.configure({{0, 0, -10}, 0.0}, integrator, {});
  std::vector<double> z{0.0};
  std::vector<double> minima;
  run(sim, h, static_cast<int>(std::lround(time / h)), hold(net.initial, {0, 1}), [&](int) {
    z.push_back(sim.state().x[49].z());
    const std::size_t k = z.size() - 1;
    if (k >= 2 && z[k - 1] < z[k - 2] && z[k - 1] < z[k] && z[k - 1] < -0.03)
      minima.push_back(z[k - 1]);
  });
  return minima;
}

// A row of six decimals; the minima are those of the samples.
void expect_minima(const std::vector<double>& found, const std::vector<double>& wanted,
                   double tolerance) {
  ASSERT_GE(found.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) EXPECT_NEAR(found[k], wanted[k], tolerance) << k;
}

TEST(Vibration, ImplicitEulerDampsAsComputed) {
  expect_minima(tip_minima(Method::implicit_euler, 1e-3, 1.2),
                {-0.070088, -0.068557, -0.067093, -0.065690}, 1e-5);
  expect_minima(tip_minima(Method::implicit_euler, 1e-2, 1.3),
                {-0.063783, -0.053856, -0.048145, -0.044951}, 1e-5);
}

TEST(Vibration, TrapezoidKeepsTheAmplitude) {
  expect_minima(tip_minima(Method::newmark, 1e-4, 1.15),
                {-0.070920, -0.070899, -0.070924, -0.070863}, 1e-4);
}

}  // namespace
}  // namespace retiarius

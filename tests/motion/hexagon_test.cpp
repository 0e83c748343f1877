// The hexagon net under gravity: heights of its centre computed independently of this project
// (side 1 m, mesh 0.2 m, 4 segments a piece, E 1 MPa, rho 1000 kg/m3, r0 1 cm, mu 0.1 1/s,
// g 50 m/s2, corners held, stretching only).
#include <utility>

#include <gtest/gtest.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/motion/integrator.hpp"
#include "tests/motion/advance.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

const EnvironmentSpec kSurroundings{{0, 0, -50}, 0.1};

const Network& hexagon() {
  static const Network net = [] {
    NetSpec spec;
    spec.pattern = Pattern::hexagon;
    spec.side = 1.0;
    spec.mesh = 0.2;
    spec.segments = 4;
    spec.thread.young_modulus = 1e6;
    spec.thread.density = 1000.0;
    spec.thread.radius = 0.01;
    return build_network(spec);
  }();
  return net;
}

const std::vector<Body> kNoBodies;

Simulation falling(Method method) {
  Simulation sim(hexagon(), kNoBodies, initial_state(hexagon(), kNoBodies));
  IntegratorSpec integrator;
  integrator.method = method;
  sim.configure(kSurroundings, integrator, {});
  return sim;
}

// The rows have six decimals; the run is chaotic late, so that the last half second compares
// loosely.
TEST(Hexagon, FallsAsComputedIndependently) {
  const std::vector<std::pair<int, double>> wanted = {
      {5, -0.074825},   {10, -0.273698},  {15, -0.559344},  {20, -0.643201},  {25, -0.434544},
      {30, -0.253291},  {35, -0.205719},  {40, -0.306743},  {50, -0.562176},  {55, -0.469970},
      {60, -0.369253},  {70, -0.386874},  {80, -0.494854},  {90, -0.410295},  {100, -0.410133},
      {110, -0.466735}, {120, -0.422524}, {140, -0.450930}, {150, -0.428884}, {160, -0.429434},
      {170, -0.443093}, {180, -0.431883}, {190, -0.432277}, {200, -0.439135}};
  Simulation sim = falling(Method::implicit_euler);
  EXPECT_NEAR(hexagon().mass.size(), 631, 0);
  auto row = wanted.begin();
  double worst = 0.0, worst_late = 0.0;
  run(sim, 0.01, 200, hold(hexagon().initial, hexagon().corners), [&](int k) {
    if (row == wanted.end() || row->first != k) return;
    const double off = std::abs(sim.state().x[hexagon().center].z() - row->second);
    double& largest = k <= 150 ? worst : worst_late;
    largest = std::max(largest, off);
    EXPECT_LT(off, k <= 150 ? 1e-5 : 2e-3) << "at " << k * 0.01 << " s";
    ++row;
  });
  RecordProperty("largest_error_to_1.5_s", std::to_string(worst));
  RecordProperty("largest_error_to_2_s", std::to_string(worst_late));
}

// Trapezoid rule at h = 0.002: six decimals are given.
TEST(Hexagon, TrapezoidKeepsTheOscillation) {
  const std::vector<std::pair<int, double>> wanted = {
      {25, -0.062396}, {50, -0.249169}, {75, -0.557240}, {100, -0.732504}};
  Simulation sim = falling(Method::newmark);
  auto row = wanted.begin();
  run(sim, 0.002, 100, hold(hexagon().initial, hexagon().corners), [&](int k) {
    if (row == wanted.end() || row->first != k) return;
    EXPECT_NEAR(sim.state().x[hexagon().center].z(), row->second, 1e-6) << k * 0.002 << " s";
    ++row;
  });
}

TEST(Hexagon, StaticEquilibrium) {
  Simulation sim = falling(Method::static_solve);
  const std::vector<Prescribed> held = held_at(hexagon().initial, hexagon().corners);
  sim.solve_static(held);
  EXPECT_NEAR(sim.state().x[hexagon().center].z() / -0.43500957, 1.0, 1e-6 * 0.1);
  double strain = 0.0;
  for (const Segment& s : hexagon().segments)
    strain = std::max(strain, axial_strain(sim.state().x[s.a], sim.state().x[s.b], s.rest_length));
  EXPECT_NEAR(strain / 0.1722447640, 1.0, 1e-9);
  const Index corner = hexagon().corners[0];  // at +x
  EXPECT_NEAR(sim.state().support[corner].z() / 94.247780, 1.0, 1e-8);
  EXPECT_NEAR(sim.state().support[corner].x() / 97.21597, 1.0, 1e-7);
  EXPECT_NEAR(sim.state().support[corner].y(), 0.0, 1e-6);
}

State run_with(int threads_used) {
  set_threads(threads_used);
  Simulation sim = falling(Method::implicit_euler);
  run(sim, 0.01, 30, hold(hexagon().initial, hexagon().corners));
  set_threads(1);
  return sim.state();
}

TEST(Hexagon, RepeatsBitForBitWhateverTheNumberOfThreads) {
  const State first = run_with(1);
  for (int count : {1, 2, 4}) {
    const State again = run_with(count);
    for (std::size_t i = 0; i < first.x.size(); ++i) {
      ASSERT_EQ(first.x[i], again.x[i]) << count << " threads, node " << i;
      ASSERT_EQ(first.v[i], again.v[i]) << count << " threads, node " << i;
    }
  }
}

}  // namespace
}  // namespace retiarius

#include "benchmarks/family.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "retiarius/base/parallel.hpp"

namespace retiarius::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

struct Repeat {
  double step = 0.0;
  WorkTimes work;
  int iterations = 0, factorisations = 0;
};

Repeat run_once(const Network& network, const Settings& settings) {
  const std::vector<Body> none;
  Simulation simulation(network, none, initial_state(network, none), {}, settings.make_solver());
  IntegratorSpec integrator;
  integrator.step = settings.h;
  integrator.tolerance = 1e-6;
  integrator.solver = settings.solver;
  integrator.newton = settings.newton;
  simulation.configure({{0.0, 0.0, -50.0}, 0.1}, integrator, {});
  std::vector<Prescribed> held;
  for (Index corner : network.corners)
    held.push_back({corner, network.initial[corner], Vec3::Zero()});
  const PrescribedMotion hold = [&held](double) { return held; };
  Repeat repeat;
  const auto start = Clock::now();
  for (int k = 1; k <= settings.steps; ++k) {
    while (simulation.state().time < k * settings.h) {
      const StepReport report = simulation.advance(k * settings.h, hold);
      repeat.iterations += report.iterations;
      repeat.factorisations += report.factorisations;
    }
  }
  const std::chrono::duration<double> wall = Clock::now() - start;
  repeat.step = wall.count() / settings.steps;
  repeat.work = simulation.work_times();
  return repeat;
}

}  // namespace

NetSpec net_of(const Member& member) {
  NetSpec spec;
  spec.pattern = Pattern::hexagon;
  spec.side = 1.0;
  spec.mesh = 1.0 / member.n;
  spec.segments = member.s + 1;
  spec.knots = member.across ? Knots::continuous : Knots::hinged;
  spec.thread.young_modulus = 1e6;
  spec.thread.density = 1000.0;
  spec.thread.radius = 0.01 * std::sqrt(std::min(1.0, 5.0 / member.n));
  spec.thread.bending = member.bending ? Bending::bounded : Bending::none;
  return spec;
}

Measurement measure(const Member& member, const Settings& settings) {
  const Network network = build_network(net_of(member));
  std::vector<Repeat> repeats;
  for (int k = 0; k < settings.repeats; ++k) repeats.push_back(run_once(network, settings));
  std::sort(repeats.begin(), repeats.end(),
            [](const Repeat& a, const Repeat& b) { return a.step < b.step; });
  const Repeat& median = repeats[repeats.size() / 2];
  Measurement m;
  m.member = member;
  m.nodes = network.node_count();
  m.h = settings.h;
  m.threads = threads();
  m.solver = settings.newton == Newton::single      ? "single"
             : settings.solver == Solver::automatic ? "auto"
             : settings.solver == Solver::pcg       ? "pcg"
             : settings.solver == Solver::direct    ? "direct"
                                                    : "reuse";
  m.steps = settings.steps;
  m.step = median.step;
  m.assembly = median.work.assembly / settings.steps;
  m.factor = median.work.factor / settings.steps;
  m.solve = median.work.solve / settings.steps;
  m.rest = m.step - m.assembly - m.factor - m.solve;
  m.iterations = static_cast<double>(median.iterations) / settings.steps;
  m.factorisations = static_cast<double>(median.factorisations) / settings.steps;
  return m;
}

}  // namespace retiarius::benchmarks

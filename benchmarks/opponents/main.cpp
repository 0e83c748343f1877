// retiarius-bench: our linear solver against others on the matrices of falling nets, and our
// integrators against plain ones, in one run.
#include <map>
#include <string>

#include <benchmark/benchmark.h>

#include "benchmarks/family.hpp"
#include "benchmarks/flights.hpp"
#include "benchmarks/opponents/solvers.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/forces/bending.hpp"
#include "retiarius/forces/stretching.hpp"
#include "retiarius/motion/integrator.hpp"

// Of the BLAS.
extern "C" void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*,
                       const double*, const int*, const double*, const int*, const double*, double*,
                       const int*);

namespace retiarius::benchmarks {
namespace {

// The matrix of an implicit Euler step (h = 0.01 s) of a net that has fallen for ten of them.
struct StepMatrix {
  BlockPattern pattern;
  BlockMatrix matrix;
};

StepMatrix& step_matrix(const Member& member) {
  static std::map<std::pair<int, int>, StepMatrix> made;
  auto [at, fresh] = made.try_emplace({member.n, member.s});
  StepMatrix& m = at->second;
  if (!fresh) return m;
  const Network network = build_network(net_of(member));
  const std::vector<Body> none;
  Simulation simulation(network, none, initial_state(network, none));
  simulation.configure({{0.0, 0.0, -50.0}, 0.1}, {}, {});
  std::vector<Prescribed> held;
  for (Index corner : network.corners)
    held.push_back({corner, network.initial[corner], Vec3::Zero()});
  for (int k = 1; k <= 10; ++k) simulation.advance(0.01 * k, [&](double) { return held; });
  Stretching stretching(network);
  BendingLaw bending(network);
  m.pattern = BlockPattern(network.node_count());
  stretching.couple(m.pattern);
  bending.couple(m.pattern);
  m.pattern.finish();
  stretching.bind(m.pattern);
  bending.bind(m.pattern);
  m.matrix.reset(m.pattern);
  const Step step = make_step(Method::implicit_euler, simulation.state(), 0.01);
  stretching.prepare(step);
  std::vector<Vec3> gradient(network.mass.size(), Vec3::Zero());
  Assembly out{&gradient, &m.matrix, true};
  stretching.assemble(step, simulation.state().x, out);
  bending.assemble(step, simulation.state().x, out);
  for (std::size_t i = 0; i < network.mass.size(); ++i)
    m.matrix.diagonal[i].diagonal().array() += step.inertia * network.mass[i];
  return m;
}

using Maker = std::unique_ptr<LinearSolver> (*)();

void factor_and_solve(benchmark::State& state, Maker make) {
  set_threads(1);
  const StepMatrix& m =
      step_matrix({static_cast<int>(state.range(0)), static_cast<int>(state.range(1))});
  const std::unique_ptr<LinearSolver> solver = make();
  solver->analyse(m.pattern);
  std::vector<Vec3> x(m.matrix.diagonal.size());
  for ([[maybe_unused]] auto _ : state) {
    if (!solver->factor(m.matrix)) state.SkipWithError("not positive definite");
    std::fill(x.begin(), x.end(), Vec3::Ones());
    solver->solve(x);
    benchmark::DoNotOptimize(x.data());
  }
  state.counters["nodes"] = static_cast<double>(x.size());
  // Items are the factorisation's floating-point operations, over the time of both.
  const auto flops = static_cast<int64_t>(solver->factor_flops());
  if (flops > 0) state.SetItemsProcessed(flops * state.iterations());
}

// The most that a processor is seen to do: the matrix product of the BLAS that CHOLMOD uses.
void matrix_product(benchmark::State& state) {
  const int n = 768;
  const std::vector<double> a(static_cast<std::size_t>(n) * n, 0.5);
  std::vector<double> c(a.size(), 0.0);
  const double one = 1.0, zero = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &zero, c.data(), &n);
    benchmark::DoNotOptimize(c.data());
  }
  state.SetItemsProcessed(2L * n * n * n * state.iterations());
}

// The whole step from the flat start; with Solver::direct with a new factorisation for every
// iteration.
void step(benchmark::State& state, Maker make, Solver way) {
  set_threads(1);
  Settings settings;
  settings.steps = 10;
  settings.repeats = 1;
  settings.solver = way;
  settings.make_solver = make;
  const Member member{static_cast<int>(state.range(0)), static_cast<int>(state.range(1))};
  for ([[maybe_unused]] auto _ : state) {
    const Measurement m = measure(member, settings);
    state.SetIterationTime(m.step);
    state.counters["nodes"] = m.nodes;
    state.counters["iterations"] = m.iterations;
  }
}

void steps(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->ArgNames({"n", "s"})->UseManualTime()->Iterations(3);
  for (const auto& [n, s] : {std::pair{11, 3}, {21, 3}}) b->Args({n, s});
}

BENCHMARK_CAPTURE(step, ours, make_net_solver, Solver::direct)->Apply(steps);
BENCHMARK_CAPTURE(step, ours_as_it_is, make_net_solver, Solver::automatic)->Apply(steps);
BENCHMARK_CAPTURE(step, cholmod_supernodal, make_cholmod_solver, Solver::direct)->Apply(steps);
BENCHMARK_CAPTURE(step, eigen_metis, make_eigen_metis_solver, Solver::direct)->Apply(steps);

// The first tenth of a second of a stiff net's flight, in which its threads snap taut.
void flight(benchmark::State& state, Way way) {
  set_threads(1);
  Flight f;
  f.segments = static_cast<int>(state.range(0));
  f.way = way;
  f.until = 0.1;
  if (way == Way::euler) f.step = euler_step(f.segments);
  for ([[maybe_unused]] auto _ : state) {
    const FlightResult result = fly(f);
    state.SetIterationTime(result.seconds);
    state.counters["nodes"] = result.nodes;
    state.SetLabel(result.taken);
  }
}

void flights(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->ArgName("segments")->UseManualTime()->Iterations(3);
  for (const int segments : {2, 4, 10}) b->Arg(segments);
}

BENCHMARK_CAPTURE(flight, automatic, Way::automatic)->Apply(flights);
BENCHMARK_CAPTURE(flight, plain_explicit, Way::plain)->Apply(flights);
BENCHMARK_CAPTURE(flight, implicit_euler, Way::euler)->Apply(flights);

void nets(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->ArgNames({"n", "s"});
  for (const auto& [n, s] : {std::pair{11, 3}, {21, 3}, {37, 3}, {12, 9}, {27, 0}}) b->Args({n, s});
}

BENCHMARK_CAPTURE(factor_and_solve, ours, make_net_solver)->Apply(nets);
BENCHMARK_CAPTURE(factor_and_solve, cholmod_supernodal, make_cholmod_solver)->Apply(nets);
BENCHMARK_CAPTURE(factor_and_solve, eigen_metis, make_eigen_metis_solver)->Apply(nets);
BENCHMARK_CAPTURE(factor_and_solve, eigen_amd, make_eigen_amd_solver)->Apply(nets);
BENCHMARK(matrix_product)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace retiarius::benchmarks

BENCHMARK_MAIN();

#include "retiarius/motion/choice.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "retiarius/motion/simulation.hpp"
#include "retiarius/motion/stable_step.hpp"
#include "retiarius/solve/linear_solver.hpp"

namespace retiarius {

namespace {

// Times in s, measured on nets with vectors of eight numbers; only their ratios decide.
// Of an explicit sub-step: a node inside a piece with its segment, a knot with its ends, a joint.
constexpr double kInner = 1.8e-9, kKnot = 8e-9, kJoint = 2e-8;
// Of a factorisation: an operation, an entry of the factor.
constexpr double kFlop = 4e-11, kEntry = 1.2e-9;
// Of an iteration: assembly and what else goes with a node; the solution with an entry.
constexpr double kNode = 8e-8, kSolved = 5e-10;
// Of an iteration of conjugate gradients: a block, a node.
constexpr double kBlock = 5e-9, kVector = 1.2e-8;
// Conjugate gradients are taken where they need this share of the factorisation's time.
constexpr double kGain = 0.5;
// Implicit Euler's steps, in crossings of a piece, that keep a mouth's area within 1 % through the
// snaps of a deployment: 1 to 10 were found.
constexpr double kCrossings = 5.0;

// Of Newton's iteration in one step, over the stable step of length 1. Threads that become taut or
// slack within the step cost iterations of their own.
double iterations(const WorkCounts& work, const IntegratorSpec& integrator, double ratio) {
  if (integrator.newton == Newton::single) return 1.0;
  if (work.compression) return 2.0 + 0.8 * std::log1p(ratio);
  const double digits = -std::log10(std::min(0.1, integrator.tolerance));
  return (2.5 + 0.1 * std::pow(ratio, 0.75)) * digits / 5.0;
}

std::string seconds(double cost) { return fmt::format("{:.2g} s", cost); }

void choose_method(const WorkCounts& work, const IntegratorSpec& integrator,
                   const ContactSpec& contact, Choice& choice) {
  choice.method = Method::implicit_euler;
  std::string& why = choice.method_reason;
  if (contact.method == ContactMethod::barrier) {
    why = "barriers need an implicit method";
  } else if (integrator.newton == Newton::single) {
    why = "a single Newton update is asked for";
  }
  if (integrator.adaptive) {
    const bool damps_little = work.compression && why.empty();
    if (damps_little) choice.method = Method::tr_bdf2;
    why = damps_little  ? "steps are adaptive and all threads carry compression"
          : why.empty() ? "steps are adaptive and threads carry no compression"
                        : "steps are adaptive, and " + why;
  }
  if (!why.empty()) return;
  const double h = comparable_step(work, integrator);
  const double by_substeps = explicit_cost(work, integrator);
  const double by_steps = implicit_cost(work, integrator, h);
  if (by_substeps <= by_steps) choice.method = Method::explicit_differences;
  why = fmt::format(
      "a second of motion takes about {} by explicit sub-steps and {} by implicit Euler in steps "
      "of "
      "{:.3g} s{}",
      seconds(by_substeps), seconds(by_steps), h,
      h < integrator.step ? ", which snaps of threads need for 1 % of the mouth's area" : "");
}

void choose_solver(const WorkCounts& work, const IntegratorSpec& integrator, bool bodies,
                   Choice& choice) {
  std::string& why = choice.solver_reason;
  const bool steps = choice.method != Method::static_solve;
  if (steps && !bodies && integrator.newton == Newton::converged) {
    const double gradients = gradients_cost(work, integrator.step);
    const double factor = factor_cost(work);
    if (gradients < kGain * factor) {
      choice.solver = Solver::pcg;
      why = fmt::format("conjugate gradients take about {} where a factorisation takes {}",
                        seconds(gradients), seconds(factor));
      return;
    }
  }
  choice.solver = work.compression ? Solver::reuse : Solver::direct;
  why = work.compression ? "all threads carry compression, so that old factorisations serve on"
                         : "threads carry no compression, so that old factorisations seldom serve";
}

}  // namespace

const char* to_string(Solver solver) {
  switch (solver) {
    case Solver::automatic:
      return "auto";
    case Solver::direct:
      return "direct";
    case Solver::reuse:
      return "reuse";
    case Solver::pcg:
      return "pcg";
  }
  return "";
}

WorkCounts count_work(const Network& network) {
  WorkCounts work;
  work.nodes = network.node_count();
  std::vector<int> degree(network.mass.size(), 0);
  double travel = 0.0;  // of a wave along all threads, s
  for (const Segment& s : network.segments) {
    const Material& m = network.materials[s.material];
    ++degree[s.a];
    ++degree[s.b];
    travel += s.rest_length / std::sqrt(m.axial_stiffness / m.line_density);
  }
  double ends = 0.0;
  for (const int d : degree) {
    if (d == 2)
      work.inner += 1.0;
    else
      ends += d;
  }
  if (travel > 0.0) work.crossing = travel / std::max(1.0, 0.5 * ends);
  work.joints = static_cast<double>(
      std::count_if(network.joints.begin(), network.joints.end(),
                    [](const Joint& joint) { return joint.bending_stiffness > 0.0; }));
  work.stable_step = stable_explicit_step(network).step;
  work.compression = std::all_of(network.materials.begin(), network.materials.end(),
                                 [](const Material& m) { return m.compression; });
  return work;
}

double explicit_cost(const WorkCounts& work, const IntegratorSpec& integrator) {
  const double substep =
      kInner * work.inner + kKnot * (work.nodes - work.inner) + kJoint * work.joints;
  const double h = std::min(integrator.step, longest_substep(work.stable_step, integrator));
  return substep / h;
}

double implicit_cost(const WorkCounts& work, const IntegratorSpec& integrator, double h) {
  const double count = iterations(work, integrator, h / work.stable_step);
  const double factorisations = work.compression ? std::min(2.0, count) : count;
  return (factorisations * factor_cost(work) +
          count * (kNode * work.nodes + kSolved * work.factor_entries)) /
         h;
}

double comparable_step(const WorkCounts& work, const IntegratorSpec& integrator) {
  return work.compression ? integrator.step : std::min(integrator.step, kCrossings * work.crossing);
}

// The number of iterations follows from the spread of the eigenvalues of h^2 K / m, from 0 to
// (2 h / stable step)^2.
double gradients_cost(const WorkCounts& work, double h) {
  const double ratio = 2.0 * h / work.stable_step;
  const double count = 0.5 * std::sqrt(1.0 + ratio * ratio) * std::log(2.0 / kPcgTolerance);
  return count * (kBlock * (work.nodes + 2.0 * work.pairs) + kVector * work.nodes);
}

double factor_cost(const WorkCounts& work) {
  return kFlop * work.factor_flops + kEntry * work.factor_entries;
}

Choice choose(const WorkCounts& work, const IntegratorSpec& integrator, const ContactSpec& contact,
              bool bodies) {
  Choice choice;
  choice.method = integrator.method;
  choice.solver = integrator.solver;
  if (integrator.method == Method::automatic) choose_method(work, integrator, contact, choice);
  if (integrator.solver == Solver::automatic && choice.method != Method::explicit_differences)
    choose_solver(work, integrator, bodies, choice);
  return choice;
}

}  // namespace retiarius

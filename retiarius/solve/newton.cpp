#include "retiarius/solve/newton.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace retiarius {

namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMostHalvings = 33;  // down to 1e-10

// Finds a direction of descent: with the full Hessian first, with the projected one if that has
// a pivot that is not positive.
bool find_descent(NewtonProblem& problem, NewtonResult& result) {
  if (problem.find_direction() && problem.slope() <= 0.0) return true;
  ++result.projections;
  problem.assemble(true);
  return problem.find_direction() && problem.slope() <= 0.0;
}

// Halves the step until the potential falls enough (Armijo). Close to the minimum the fall
// drowns in round-off; there a step counts as good if it leaves a smaller slope (Hager and Zhang
// 2005). Returns the accepted fraction with the problem assembled there, or 0.
double line_search(NewtonProblem& problem, double& value) {
  const double slope = problem.slope();
  const double noise = 1e-12 * std::abs(value) + 1e-300;
  for (int halvings = 0; halvings <= kMostHalvings; ++halvings) {
    const double fraction = std::ldexp(1.0, -halvings);
    problem.move(fraction);
    double trial = fraction == 1.0 ? problem.assemble(false) : problem.potential();
    if (!std::isfinite(trial)) continue;
    const bool falls = trial <= value + kArmijo * fraction * slope;
    const bool level = std::abs(trial - value) <= noise && fraction == 1.0 &&
                       std::abs(problem.slope()) <= 0.9 * std::abs(slope);
    const bool still = std::abs(slope) <= noise;
    if (!falls && !level && !still) continue;
    if (fraction != 1.0) trial = problem.assemble(false);
    value = trial;
    return fraction;
  }
  return 0.0;
}

}  // namespace

NewtonResult minimise(NewtonProblem& problem, const NewtonSettings& settings) {
  NewtonResult result;
  double value = problem.assemble(false);
  while (result.iterations < settings.max_iterations) {
    if (!std::isfinite(value)) {
      result.failure = "the potential is not finite";
      return result;
    }
    ++result.iterations;
    if (!find_descent(problem, result)) {
      result.failure = "the projected matrix is not positive definite";
      return result;
    }
    const double size = problem.direction_size();
    const double fraction = line_search(problem, value);
    if (fraction == 0.0) {
      result.failure =
          fmt::format("the line search found no descent at iteration {}", result.iterations);
      return result;
    }
    const double moved = size * fraction;
    const double ratio = problem.residual_ratio();
    const bool full = (moved <= settings.step_tolerance && ratio <= 1.0) ||
                      (moved <= settings.round_off_step && ratio <= settings.round_off_ratio);
    const bool loose = fraction == 1.0 && size <= settings.loose_step_tolerance &&
                       ratio <= settings.loose_residual_ratio;
    if ((full || loose) && problem.revise(full)) {
      value = problem.assemble(false);
      continue;
    }
    if (full) {
      result.converged = true;
      return result;
    }
  }
  result.failure = fmt::format("no convergence within {} iterations", settings.max_iterations);
  return result;
}

}  // namespace retiarius

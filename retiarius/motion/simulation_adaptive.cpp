// Steps whose length follows the local error.
#include <algorithm>
#include <cmath>

#include "retiarius/motion/local_error.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius {

namespace {

// A step that is still too inaccurate after so many is taken all the same: the motion has a kink.
constexpr int kMostRejections = 4;
constexpr double kSmallestShare = 1e-3;  // of the largest step, where none is given

}  // namespace

// Root mean square over the nodes, over the median rest length. Filtered by the last matrix: what
// stiff threads do faster than the step can follow is damped away by the scheme, not resolved.
double Simulation::local_error(std::vector<Vec3> error) const {
  problem_->filter(error);
  double sum = 0.0;
  for (const Vec3& e : error) sum += e.squaredNorm();
  return std::sqrt(sum / static_cast<double>(error.size())) / length_scale_;
}

StepReport Simulation::advance_adaptive(double end, const PrescribedMotion& motion) {
  const int order = local_order(integrator_.method);
  const double growth = most_growth(integrator_);
  const double largest = integrator_.step;
  const double smallest = std::min(
      largest, integrator_.min_step > 0.0 ? integrator_.min_step : kSmallestShare * largest);
  const State before = state_;
  const std::vector<double> tensions = tensions_;
  const double planned = before.memory.next_step;
  double wanted = planned > 0.0 ? std::clamp(planned, smallest, largest) : largest;
  StepReport total;
  double last_h = 0.0, last_ratio = 0.0;
  for (;;) {
    const double remaining = end - before.time;
    const double part = part_of(remaining, wanted);
    const StepReport step = advance_fixed(part == remaining ? end : before.time + part, motion);
    total.h = step.h;
    total.iterations += step.iterations;
    total.factorisations += step.factorisations;
    total.projections += step.projections;
    total.halvings += step.halvings;
    total.error = local_error_ / integrator_.accuracy;
    const bool good = total.error <= 1.0;
    const bool kink =
        !good && total.rejections > 0 && at_kink(last_h, last_ratio, step.h, total.error, order);
    const bool shortest = step.h <= 1.0001 * smallest;
    if (good || kink || shortest || total.rejections == kMostRejections) {
      double next = fitting_step(step.h, total.error, order, growth);
      if (total.rejections > 0 || step.halvings > 0) next = std::min(next, step.h);
      // A kink says nothing of the motion after it, a step cut by `end` nothing of longer ones.
      if (kink) next = step.h;
      if (good && step.h < wanted && step.halvings == 0) next = std::max(next, wanted);
      state_.memory.next_step = std::clamp(next, smallest, largest);
      return total;
    }
    last_h = step.h;
    last_ratio = total.error;
    wanted = std::max(smallest, fitting_step(step.h, total.error, order, growth));
    ++total.rejections;
    state_ = before;
    tensions_ = tensions;
  }
}

}  // namespace retiarius

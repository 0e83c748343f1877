#include "retiarius/forces/environment_damping.hpp"

#include "retiarius/base/parallel.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kNodes = 4096;  // that a thread takes at once

// The velocity that the step's damping force averages to: the trapezoid takes the mean of the
// velocities at its two ends.
Vec3 mean_velocity(const Step& step, Index i, const Vec3& y) {
  Vec3 stage = step.stage_velocity(i, y);
  if (step.strain_rate != Step::StrainRate::trapezoid) return stage;
  return 0.5 * (stage + step.start->v[static_cast<std::size_t>(i)]);
}

}  // namespace

// The stage velocity is linear in y, so mu m |w|^2 / (2 rate) has the gradient mu m w.
double EnvironmentDamping::potential(const Step& step, const std::vector<Vec3>& y) const {
  if (step.rate <= 0.0) return 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i)
    sum += mass_[i] * step.stage_velocity(static_cast<Index>(i), y[i]).squaredNorm();
  return 0.5 * mu_ / step.rate * sum;
}

double EnvironmentDamping::assemble(const Step& step, const std::vector<Vec3>& y,
                                    Assembly& out) const {
  const double sum = parallel_sum(mass_.size(), kNodes, [&](std::size_t begin, std::size_t end) {
    double part = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 w = step.stage_velocity(static_cast<Index>(i), y[i]);
      (*out.gradient)[i] += mu_ * mass_[i] * w;
      if (out.hessian) out.hessian->diagonal[i].diagonal().array() += mu_ * mass_[i] * step.rate;
      part += mass_[i] * w.squaredNorm();
    }
    return part;
  });
  return step.rate > 0.0 ? 0.5 * mu_ / step.rate * sum : 0.0;
}

void EnvironmentDamping::account(const Step& step, const std::vector<Vec3>& y,
                                 const std::vector<Vec3>& x1, Exchange& exchange) const {
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const Vec3 force = -mu_ * mass_[i] * mean_velocity(step, static_cast<Index>(i), y[i]);
    const Vec3 way = x1[i] - step.start->x[i];
    exchange.environment_loss -=
        step.remembers() ? -mu_ * mass_[i] / step.h * way.squaredNorm() : force.dot(way);
    exchange.outside_impulse += step.h * force;
    exchange.outside_angular_impulse += step.h * y[i].cross(force);
  }
}

}  // namespace retiarius

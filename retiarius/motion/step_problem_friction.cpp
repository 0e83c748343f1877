// Friction on nodes that slide: a potential with a lagged limit, smooth where the slip is small.
#include <cmath>

#include "retiarius/contact/barrier_function.hpp"
#include "retiarius/motion/step_problem.hpp"

namespace retiarius {

// Displacement of a sliding node along the surface, relative to the body, over the step, m.
Vec3 StepProblem::slip(const Constraint& c) const {
  const Step& step = *start_.step;
  const Vec3& x0 = step.start->x[c.node];
  Vec3 u = x0 + step.reach * (y_[c.node] - x0) - c.carried;
  if (c.body != kNone) u -= step.reach * (lever_map(c) * b_[c.body]);
  return u - c.blocked * u;
}

Vec3 StepProblem::friction_force(const Constraint& c) const {
  if (c.limit <= 0.0) return Vec3::Zero();
  const Vec3 u = slip(c);
  return -c.limit / std::hypot(u.norm(), c.smoothing) * u;
}

double StepProblem::friction_potential() const {
  double value = 0.0;
  for (const Constraint& c : constraints_)
    if (c.limit > 0.0) value += c.limit * std::hypot(slip(c).norm(), c.smoothing);
  return value / start_.step->reach;
}

// Adds gradient and, where wanted, Hessian in the nodes and the bodies that they slide on; returns
// the potential.
double StepProblem::add_friction(bool hessian) {
  const double reach = start_.step->reach;
  double value = 0.0;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    const Constraint& c = constraints_[k];
    if (c.limit <= 0.0) continue;
    const Vec3 u = slip(c);
    const double onward = slips_before_.empty() ? 1.0 : share_of_newton(slips_before_[k], u);
    const double size = std::hypot(u.norm(), c.smoothing);
    const Vec3 force = -c.limit / size * u;
    value += c.limit * size;
    gradient_[c.node] -= force;
    const Mat3 h = c.limit * reach / size *
                   (Mat3::Identity() - c.blocked - onward * u * u.transpose() / (size * size));
    if (hessian) matrix_.diagonal[c.node] += h;
    if (c.body == kNone) continue;
    const Mat36 j = lever_map(c);
    body_gradient_[c.body] += j.transpose() * force;
    if (!hessian) continue;
    node_body_.push_back({c.node, c.body, -h * j});
    body_body_.push_back({c.body, c.body, j.transpose() * h * j});
  }
  return value / reach;
}

}  // namespace retiarius

// Estimates of the error of position that one step makes, and how they steer the next step.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/motion/spec.hpp"

namespace retiarius {

// The leading term of each node's error, m, from what the step knows anyway. `change`: of the
// velocity over the step by the laws alone, m/s; `acceleration`: at its start, m/s2. With the
// acceleration x2 and its derivative x3:
//
//   implicit Euler:      h / 2 change                           (h^2 / 2 x2)
//   Newmark, midpoint:   h / 6 (change - h a0)                  (h^3 / 12 x3)
//   generalised alpha:   (beta - gamma / 2 + 1 / 12) h^2 (a1 - a0)
std::vector<Vec3> one_stage_error(const IntegratorSpec& integrator, double h,
                                  const std::vector<Vec3>& acceleration,
                                  const std::vector<Vec3>& change);

// TR-BDF2: divided difference of the velocities at start, stage and end (Hosea and Shampine 1996).
// first, second: their changes in the two stages by the laws alone, m/s.
std::vector<Vec3> two_stage_error(double h, const std::vector<Vec3>& first,
                                  const std::vector<Vec3>& second);

// Power of h that the local error goes with.
int local_order(Method method);

// The largest growth from one step to the next. Generalised alpha carries accelerations whose
// fastest part changes sign and keeps the share alpha_m / (1 - alpha_m) in each step, while their
// effect goes with h^2: where steps grow faster than the square root of its inverse (1.17 for rho =
// 0.9) a snap's acceleration is amplified instead of forgotten. 2 for the others.
double most_growth(const IntegratorSpec& integrator);

// The step that would have made the error 0.9^order of what is allowed, where one of length h (s)
// made `ratio` of that; at most `growth` times and at least a fifth of h.
double fitting_step(double h, double ratio, int order, double growth);

// Whether a step that was shortened from `before` to h has not gained what a smooth motion would
// give it, on a logarithmic scale at least half: then something snapped or touched in it, and
// shorter ones would gain as little.
bool at_kink(double before, double ratio_before, double h, double ratio, int order);

// A part of the remaining time close to the wanted step, such that no sliver is left.
double part_of(double remaining, double wanted);

}  // namespace retiarius

// The time integrators, each reduced to one stage position that a step solves for.
#pragma once

#include <string>
#include <vector>

#include "retiarius/contact/spec.hpp"
#include "retiarius/motion/spec.hpp"
#include "retiarius/state/step.hpp"

namespace retiarius {

const char* to_string(Method method);

// Why a single Newton update cannot serve with this integrator and contact, to follow the setting's
// name; empty where it can. bodies: whether there are any to touch.
std::string single_update_refusal(const IntegratorSpec& integrator, const ContactSpec& contact,
                                  bool bodies);

// The step of length h from `start` by a dynamic method; the coefficients that laws see.
//
//   implicit Euler (Huang et al. 2022, Eq. 31): y = x1,
//     m (y - x0 - h v0) / h^2 = F(y),                          v1 = (x1 - x0) / h
//   Newmark, average acceleration (Eq. 32, beta 1/4, gamma 1/2): y = x1,
//     4 m (y - x0 - h v0 - h^2 a0 / 4) / h^2 = F(y),           v1 = 2 (x1 - x0) / h - v0
//   implicit midpoint: y = (x0 + x1) / 2,
//     4 m (y - x0 - h v0 / 2) / h^2 = F(y),                    v1 = 2 (x1 - x0) / h - v0
Step make_step(Method method, const State& start, double h);

// Where inertia alone (for Newmark: and half of the start's acceleration a0) would bring the stage.
// acceleration: at the start, m/s2, needed by Newmark only.
std::vector<Vec3> predicted_stage(Method method, const Step& step,
                                  const std::vector<Vec3>& acceleration);

// Where the iteration starts: with the velocity that the nodes have.
std::vector<Vec3> first_guess(Method method, const Step& step);

}  // namespace retiarius

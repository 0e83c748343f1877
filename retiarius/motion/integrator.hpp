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
//   generalised alpha (Chung and Hulbert 1993): y = alpha_f x0 + (1 - alpha_f) x1,
//     m ((1 - alpha_m) a1 + alpha_m a0) = F(y), x1 and v1 by Newmark's formulas with beta, gamma
//   TR-BDF2 (Bank et al. 1985, gamma = 2 - sqrt 2): Newmark over gamma h, which is what make_step
//     gives, then second-order backward differences over the rest (make_bdf2_step)
//
// Generalised alpha's stage velocity has a part of a0 besides: see alpha_drift.
Step make_step(Method method, const State& start, double h, double rho = 0.9);

// Parameters of generalised alpha by its spectral radius at infinite frequency, 0 <= rho <= 1.
struct GeneralisedAlpha {
  double alpha_m, alpha_f, beta, gamma;
};
GeneralisedAlpha generalised_alpha(double rho);

// The part of generalised alpha's stage velocity that comes of the start's acceleration, m/s.
// Must outlive the step that gets it as its drift.
std::vector<Vec3> alpha_drift(double rho, const Step& step, const std::vector<Vec3>& acceleration);

// Where inertia alone (for Newmark and generalised alpha: and their share of the start's
// acceleration a0) would bring the stage. acceleration: at the start, m/s2, needed by those two.
// room: memory to use for it.
std::vector<Vec3> predicted_stage(Method method, const Step& step,
                                  const std::vector<Vec3>& acceleration, double rho = 0.9,
                                  std::vector<Vec3> room = {});

// Where the iteration starts: with the velocity that the nodes have.
std::vector<Vec3> first_guess(Method method, const Step& step, std::vector<Vec3> room = {});

namespace tr_bdf2 {

// Share of the step that the first stage takes: 2 - sqrt 2 makes the matrices of both stages one.
inline constexpr double kGamma = 0.58578643762690495;
// What the second stage repeats of the first one's change: (1 - gamma)^2 / (gamma (2 - gamma)).
inline constexpr double kRepeat = (1.0 - kGamma) * (1.0 - kGamma) / (kGamma * (2.0 - kGamma));

}  // namespace tr_bdf2

// The second stage of TR-BDF2 from the end of the first, which took gamma of `whole` (s):
//   v1 = v_g + c (v_g - v0) + gamma h / 2 F(x1) / m,   x1 likewise,   c = tr_bdf2::kRepeat.
// change: of each node's velocity in the first stage by the laws alone, m/s: what contact and
// supports did is done and not repeated. The way x_g - x0 that is repeated is that of a steadily
// accelerated motion whose velocity changed by `moved` (m/s) to the one at the stage's end; it is
// `change` for nodes that nothing holds.
struct Bdf2Step {
  Step step;
  std::vector<Vec3> drift;      // of the step, which points here
  std::vector<Vec3> predicted;  // stage that inertia alone would reach
};
void make_bdf2_step(const State& start, double whole, const std::vector<Vec3>& change,
                    const std::vector<Vec3>& moved, Bdf2Step& out);

}  // namespace retiarius

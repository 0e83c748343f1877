// The stages of a step: what goes into each and what is carried on from it.
#include "retiarius/motion/integrator.hpp"
#include "retiarius/motion/local_error.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius {

namespace {

std::vector<Vec3> times(double factor, std::vector<Vec3> x) {
  for (Vec3& v : x) v *= factor;
  return x;
}

}  // namespace

// By the laws at the start of the step; with the outside forces and their moment, as impulses of
// one second.
std::vector<Vec3> Simulation::start_acceleration(Exchange& outside) {
  Step at_start;
  at_start.start = &state_;
  at_start.h = 1.0;
  at_start.carry = -1.0;
  at_start.strain_rate = Step::StrainRate::start;
  std::vector<Vec3> a(state_.x.size(), Vec3::Zero());
  Assembly out{&a, nullptr, false};
  for (const auto& law : laws_) {
    law->prepare(at_start);
    law->assemble(at_start, state_.x, out);
    law->account(at_start, state_.x, state_.x, outside);
  }
  for (std::size_t i = 0; i < a.size(); ++i) a[i] /= -network_->mass[i];
  return a;
}

void Simulation::start_up() {
  Memory& memory = state_.memory;
  if (memory.acceleration.size() == state_.x.size()) return;
  Exchange outside;
  memory.acceleration = start_acceleration(outside);
  memory.outside_force = outside.outside_impulse;
  memory.outside_moment = outside.outside_angular_impulse;
}

// The acceleration of a held node is its path's, not the laws'. Its stage is put where the impulse
// of the laws stays the same, which its support takes.
void Simulation::follow_paths(const std::vector<Prescribed>& prescribed, const Step& step,
                              std::vector<Vec3>& drift, std::vector<Vec3>& predicted) const {
  for (const Prescribed& p : prescribed) {
    const Vec3 of_path = (p.velocity - state_.v[p.node]) / step.h;
    const Vec3 own = alpha_drift(integrator_.rho, step, {of_path}).front();
    predicted[p.node] += (drift[p.node] - own) / step.rate;
    drift[p.node] = own;
  }
}

bool Simulation::try_one_stage(double end, const PrescribedMotion& motion, StepReport& report,
                               std::string& failure) {
  const Method method = integrator_.method;
  const double h = end - state_.time;
  Step step = make_step(method, state_, h, integrator_.rho);
  std::vector<Vec3> acceleration, drift;
  double past = method == Method::newmark ? 0.5 * h : 0.0;  // s, of the start's acceleration
  if (method == Method::generalised_alpha) {
    start_up();
    acceleration = state_.memory.acceleration;
    drift = alpha_drift(integrator_.rho, step, acceleration);
    step.drift = &drift;
    const GeneralisedAlpha a = generalised_alpha(integrator_.rho);
    past = h * (1.0 - a.gamma / (1.0 - a.alpha_m));
    carried_.outside_impulse = past * state_.memory.outside_force;
    carried_.outside_angular_impulse = past * state_.memory.outside_moment;
  } else if (method == Method::newmark || integrator_.adaptive) {
    Exchange unused;
    acceleration = start_acceleration(unused);
  }
  std::vector<Vec3> predicted =
      predicted_stage(method, step, acceleration, integrator_.rho, std::move(predicted_room_));
  if (step.drift && motion) follow_paths(motion(end), step, drift, predicted);
  std::vector<Vec3> past_change;
  if (past != 0.0) past_change = times(past, acceleration);
  if (!solve_stage(step, std::move(predicted), past_change, end, motion, report, failure))
    return false;
  if (method == Method::generalised_alpha) {
    remember_acceleration(h);
  } else if (goes_on_accelerating()) {
    std::vector<Vec3>& a = state_.memory.acceleration;
    a.resize(law_change_.size());
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = law_change_[i] / h;
  } else {
    forget_acceleration();
  }
  if (integrator_.adaptive)
    local_error_ = local_error(one_stage_error(integrator_, h, acceleration, law_change_));
  return true;
}

// a1 from v1 - v0 = h ((1 - gamma) a0 + gamma a1), of each node by the laws alone: reactions of
// supports and contact act within a step and are not carried on. So too for what is from outside.
void Simulation::remember_acceleration(double h) {
  Memory& memory = state_.memory;
  const double gamma = generalised_alpha(integrator_.rho).gamma;
  const auto next = [&](const Vec3& a0, const Vec3& change) {
    return Vec3((change / h - (1.0 - gamma) * a0) / gamma);
  };
  for (std::size_t i = 0; i < memory.acceleration.size(); ++i)
    memory.acceleration[i] = next(memory.acceleration[i], law_change_[i]);
  memory.outside_force = next(memory.outside_force, exchange_.outside_impulse);
  memory.outside_moment = next(memory.outside_moment, exchange_.outside_angular_impulse);
}

// TR-BDF2: each stage is solved and accounted for as a step of its own, contact included. If the
// second one fails, so does the step.
bool Simulation::try_two_stages(double end, const PrescribedMotion& motion, StepReport& report,
                                std::string& failure) {
  const State before = state_;
  const double h = end - before.time;
  const Step first = make_step(Method::tr_bdf2, state_, h);
  Exchange unused;
  const std::vector<Vec3> acceleration = start_acceleration(unused);
  std::vector<Vec3> predicted = predicted_stage(Method::tr_bdf2, first, acceleration);
  if (!solve_stage(first, std::move(predicted), times(0.5 * first.h, acceleration),
                   before.time + first.h, motion, report, failure))
    return false;
  carried_.outside_impulse = tr_bdf2::kRepeat * exchange_.outside_impulse;
  carried_.outside_angular_impulse = tr_bdf2::kRepeat * exchange_.outside_angular_impulse;
  const std::vector<Vec3> change = law_change_;
  const std::vector<Vec3> support = state_.support;
  std::vector<Vec3> moved = change;
  for (const Constraint& c : problem_->constraints()) moved[c.node] -= c.blocked * moved[c.node];
  if (motion)
    for (const Prescribed& p : motion(state_.time)) moved[p.node] = p.velocity - before.v[p.node];
  Bdf2Step second;
  make_bdf2_step(state_, h, change, moved, second);
  if (!solve_stage(second.step, std::move(second.predicted), times(tr_bdf2::kRepeat, change), end,
                   motion, report, failure)) {
    state_ = before;
    return false;
  }
  state_.step = before.step + 1;
  for (std::size_t i = 0; i < support.size(); ++i)
    state_.support[i] = tr_bdf2::kGamma * support[i] + (1.0 - tr_bdf2::kGamma) * state_.support[i];
  forget_acceleration();
  if (integrator_.adaptive) local_error_ = local_error(two_stage_error(h, change, law_change_));
  return true;
}

}  // namespace retiarius

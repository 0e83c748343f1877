// Simulation's step by the explicit integrator.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/motion/explicit_stepper.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius {

namespace {

// The sub-step is at most this share of the step at which straight taut threads are stable; what it
// leaves is for what Gershgorin's bound does not see: folded joints, and tensions at large strains.
constexpr double kSafety = 0.9;

// A node is taken for already on its prescribed way within this distance, m.
constexpr double kSamePlace = 1e-9;

// The way to where the node is prescribed to end. Where it was already on its way the cubic follows
// the prescribed velocities, otherwise it goes there straight.
ExplicitStepper::Way way_to(const Prescribed& p, const std::vector<Prescribed>& before,
                            const State& state, double h) {
  ExplicitStepper::Way way;
  way.node = p.node;
  way.from = state.x[p.node];
  way.to = p.position;
  way.final_velocity = p.velocity;
  way.start_velocity = way.end_velocity = (way.to - way.from) / h;
  const auto found = std::find_if(before.begin(), before.end(),
                                  [&](const Prescribed& b) { return b.node == p.node; });
  if (found == before.end() || (found->position - way.from).norm() > kSamePlace) return way;
  way.start_velocity = found->velocity;
  way.end_velocity = p.velocity;
  return way;
}

}  // namespace

double longest_substep(double stable_step, const IntegratorSpec& integrator) {
  const double most = kSafety * stable_step;
  return integrator.substep > 0.0 ? std::min(most, integrator.substep) : most;
}

int explicit_substeps(double stable_step, const IntegratorSpec& integrator, double h) {
  const double most = longest_substep(stable_step, integrator);
  const double count = std::ceil(h / most * (1.0 - 1e-9));
  if (count > 1e9)
    throw RunError(fmt::format(
        "a step of {:.3g} s would take {:.3g} explicit sub-steps of {:.3g} s; take another "
        "integrator.method",
        h, count, most));
  return std::max(1, static_cast<int>(count));
}

StepReport Simulation::advance_explicitly(double end, const PrescribedMotion& motion) {
  StepReport report;
  report.h = end - state_.time;
  report.substeps = explicit_substeps(work_.stable_step, integrator_, report.h);
  ExplicitStepper::Job& job = job_;
  job.laws.clear();
  job.ways.clear();
  job.h = report.h;
  job.substeps = report.substeps;
  job.body_gravity = environment_.gravity;
  job.stretches = !wrap_;
  if (job.stretches) {
    job.gravity = environment_.gravity;
    job.damping = environment_.damping;
    if (bending_) job.laws.push_back(bending_);
  } else {
    for (const auto& law : laws_) job.laws.push_back(law.get());
  }
  if (motion) {
    const std::vector<Prescribed> before = motion(state_.time);
    for (const Prescribed& p : motion(end)) job.ways.push_back(way_to(p, before, state_, report.h));
  }
  job.contact = bodies_held_ ? nullptr : explicit_contact_.get();
  // A step that fails leaves the last accepted state.
  next_ = state_;
  next_.time = end;
  free_bodies(report.h, free_bodies_);
  explicit_->run(job, free_bodies_, next_);
  std::swap(state_, next_);
  const std::vector<BodyState>& old = next_.bodies;
  if (job.contact) report.unsettled = job.contact->unsettled();
  for (std::size_t b = 0; b < bodies_->size(); ++b) {
    if ((*bodies_)[b].fixed || bodies_held_) continue;
    const Vec3 impulse = report.h * (*bodies_)[b].mass * environment_.gravity;
    state_.account.outside_impulse += impulse;
    state_.account.outside_angular_impulse +=
        (0.5 * (old[b].position + state_.bodies[b].position)).cross(impulse);
  }
  ++state_.step;
  if (job.stretches) {
    explicit_->tensions(tensions_);
  } else {
    tensions_ = stretching_->tensions(state_.x);
  }
  return report;
}

}  // namespace retiarius

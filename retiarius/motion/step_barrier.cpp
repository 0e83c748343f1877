// What barrier contact adds to the problem of a step.
#include <algorithm>

#include "retiarius/base/stopwatch.hpp"
#include "retiarius/motion/step_problem.hpp"

namespace retiarius {

void StepProblem::find_end(End& end) const {
  const Step& step = *start_.step;
  end.nodes.resize(y_.size());
  for (std::size_t i = 0; i < y_.size(); ++i)
    end.nodes[i] = step.start->x[i] + step.reach * (y_[i] - step.start->x[i]);
  end_bodies(end.bodies);
  end.turns.resize(b_.size());
  for (std::size_t b = 0; b < b_.size(); ++b) end.turns[b] = step.reach * b_[b].tail<3>();
}

double StepProblem::add_barrier(Assembly& out) {
  const Stopwatch watch(times_.contact);
  const double reach = start_.step->reach;
  find_end(end_);
  ContactAssembly sums;
  sums.gradient = &gradient_;
  sums.body_gradient = &body_gradient_;
  sums.scale = reach;
  sums.definite = project_contact_;
  if (out.hessian) {
    sums.hessian = out.hessian;
    sums.node_body = &node_body_;
    sums.body_body = &body_body_;
  }
  return start_.barrier->evaluate(end_.places(), &sums) / reach;
}

// Threads that touch couple nodes that no law couples. What is near already is taken along, so that
// the pattern is analysed anew seldom; what has parted since is dropped then.
void StepProblem::grow_pattern() {
  const Stopwatch all(times_.assembly), watch(times_.contact);
  find_end(end_);
  const auto needed = start_.barrier->couplings(end_.places(), BarrierContact::Coupled::in_range);
  if (std::includes(couplings_.begin(), couplings_.end(), needed.begin(), needed.end())) return;
  couple(start_.barrier->couplings(end_.places(), BarrierContact::Coupled::in_reach), Order::stays);
}

void StepProblem::couple(std::vector<std::pair<Index, Index>> couplings, Order order) {
  couplings_ = std::move(couplings);
  pattern_ = laws_pattern_;
  for (const auto& [a, b] : couplings_) pattern_.couple(a, b);
  pattern_.finish();
  use_pattern(order);
}

std::vector<Index> StepProblem::couplings() const {
  std::vector<Index> nodes;
  nodes.reserve(2 * couplings_.size());
  for (const auto& [a, b] : couplings_) nodes.insert(nodes.end(), {a, b});
  return nodes;
}

// A step starts with the couplings of its start state, whatever was solved before, so that a
// resumed run eliminates in the same order.
void StepProblem::follow_couplings() {
  const std::vector<Index>& nodes = start_.step->start->memory.couplings;
  const auto same = [&] {
    if (nodes.size() != 2 * couplings_.size()) return false;
    for (std::size_t k = 0; k < couplings_.size(); ++k)
      if (nodes[2 * k] != couplings_[k].first || nodes[2 * k + 1] != couplings_[k].second)
        return false;
    return true;
  };
  if (order_ == Order::anew && same()) return;
  std::vector<std::pair<Index, Index>> couplings;
  for (std::size_t k = 0; k + 1 < nodes.size(); k += 2)
    couplings.emplace_back(nodes[k], nodes[k + 1]);
  couple(std::move(couplings), Order::anew);
}

void StepProblem::note_direction() {
  const Stopwatch all(times_.assembly), watch(times_.contact);
  find_end(end_);
  move(1.0);
  find_end(other_end_);
  move(0.0);
  start_.barrier->note_direction(end_.places(), other_end_.places());
}

double StepProblem::free_fraction(double wanted) {
  if (!start_.barrier) return wanted;
  const Stopwatch all(times_.assembly), watch(times_.contact);
  move(0.0);
  find_end(end_);
  move(wanted);
  find_end(other_end_);
  move(0.0);
  return wanted * start_.barrier->look_ahead(end_.places(), other_end_.places());
}

void StepProblem::barrier_contacts(std::vector<PairContact>& result) {
  result.clear();
  if (!start_.barrier) return;
  const Stopwatch all(times_.assembly), watch(times_.contact);
  find_end(end_);
  start_.barrier->contacts(end_.places(), result);
}

std::string StepProblem::blocked_motion() {
  if (!start_.barrier) return {};
  const Stopwatch all(times_.assembly), watch(times_.contact);
  find_end(end_);
  const State& start = *start_.step->start;
  other_end_.turns.assign(start.bodies.size(), Vec3::Zero());
  std::string pair;
  start_.barrier->motion_is_free({&start.x, &start.bodies, &other_end_.turns}, end_.places(), pair);
  return pair;
}

}  // namespace retiarius

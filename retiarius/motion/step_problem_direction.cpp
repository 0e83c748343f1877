// Newton's direction for a step's problem, with threads foreseen that become taut.
#include <algorithm>
#include <cmath>

#include "retiarius/base/parallel.hpp"
#include "retiarius/base/stopwatch.hpp"
#include "retiarius/motion/step_problem.hpp"

namespace retiarius {

namespace {

// Of the slope along a direction: the potential of what acts only at its end, beyond which that is
// foreseen. Between 0.05 and 1 the cost of a capture changes by five per cent.
constexpr double kForeseen = 0.5;

// How often a direction is looked for again for that. Two rounds more than one save 3 per cent of a
// capture's iterations.
constexpr int kMostForesights = 3;

}  // namespace

bool StepProblem::foresees() const { return one_sided_ && !start_.linear; }

// What the last direction foresaw to act is taken for active from the start, as in the quadratic
// models of an active-set method, although the present iterate may lie a little to its other side.
void StepProblem::hold() {
  foreseen_.clear();
  if (!foresees()) return;
  const Stopwatch watch(times_.assembly);
  foreseen_.assign(y_.size(), Vec3::Zero());
  const Assembly out{&foreseen_, &matrix_, false};
  bool any = false;
  for (const auto& law : *laws_) any |= law->hold(y_, out);
  if (!any) foreseen_.clear();
}

// Where the direction makes threads taut that are slack now, the matrix knows nothing of what stops
// them, and the potential rises. These are then taken for taut as well, and the direction is looked
// for again.
bool StepProblem::foresee() {
  if (!foresees()) return false;
  const Stopwatch watch(times_.assembly);
  move(1.0);
  double energy = 0.0;
  for (const auto& law : *laws_) energy += law->awaken(base_y_, y_, nullptr);
  const bool matters = energy > kForeseen * std::abs(slope());
  if (matters) {
    if (foreseen_.empty()) foreseen_.assign(y_.size(), Vec3::Zero());
    restore_rows();
    diagonal_before_ = matrix_.diagonal;
    const Assembly out{&foreseen_, &matrix_, false};
    for (const auto& law : *laws_) law->awaken(base_y_, y_, &out);
    note_changes();
  }
  move(0.0);
  return matters;
}

// The nodes whose rows and columns of the matrix awakened threads have changed: what these add to
// two nodes they add to the diagonal blocks of both.
void StepProblem::note_changes() {
  changed_.clear();
  for (std::size_t i = 0; i < y_.size(); ++i)
    if (matrix_.diagonal[i] != diagonal_before_[i]) changed_.push_back(static_cast<Index>(i));
}

bool StepProblem::find_direction() {
  hold();
  bool found = solve_anew(false);
  for (int k = 0; k < kMostForesights && found && foresee(); ++k) {
    ++foreseen_directions_;
    found = solve_anew(true);
  }
  if (found) foretell_reactions();
  foreseen_.clear();  // whether it served or not: it belongs to this direction alone
  if (!found) return false;
  led_here_ = one_sided_;
  if (start_.barrier) note_direction();
  if (start_.contact) {
    slips_before_.clear();
    for (const Constraint& c : constraints_) slips_before_.push_back(slip(c));
  }
  return true;
}

// The gradient at constrained nodes at the direction's end, as the quadratic model has it: there
// what becomes taut or slack is known better than at an iterate before convergence.
void StepProblem::foretell_reactions() {
  const Mat3 *diagonal = kept_diagonal_.data(), *row = kept_rows_.data();
  reactions_.resize(gradient_.size());
  for (const Constraint& c : constraints_) {
    Vec3 force = gradient_[c.node] + *diagonal++ * dy_[c.node];
    if (!foreseen_.empty()) force += foreseen_[c.node];
    for (Index s = neighbour_starts_[c.node]; s < neighbour_starts_[c.node + 1]; ++s)
      force += *row++ * dy_[neighbours_[s].node];
    reactions_[c.node] = force;
  }
}

// `again`: the matrix differs from the last one in changed_ alone.
bool StepProblem::factorise(bool again) {
  const Stopwatch watch(times_.factor);
  build_borders();
  keep_rows();
  filter_matrix();
  return again ? active_->refactor(matrix_, changed_) : active_->factor(matrix_);
}

// The direction for the present gradient and matrix.
bool StepProblem::solve_anew(bool again) {
  if (!factorise(again)) return false;
  solve_direction(false);
  return std::all_of(dy_.begin(), dy_.end(), [](const Vec3& d) { return d.allFinite(); });
}

// The direction for the present gradient with the present factorisation and borders.
void StepProblem::keep_direction() {
  kept_base_y_ = base_y_;
  kept_dy_ = dy_;
  kept_base_b_ = base_b_;
  kept_db_ = db_;
}

void StepProblem::restore_direction() {
  base_y_.swap(kept_base_y_);
  dy_.swap(kept_dy_);
  base_b_.swap(kept_base_b_);
  db_.swap(kept_db_);
}

void StepProblem::reuse_direction() {
  solve_direction(true);
  foretell_reactions();
  led_here_ = one_sided_;
}

// `again`: with a factorisation that has given a direction before.
void StepProblem::solve_direction(bool again) {
  const Stopwatch watch(times_.solve);
  start_direction();
  if (touching_.empty())
    active_->solve(dy_);
  else
    solve_bordered(again);
  finish_direction();
}

// The right-hand side, in the direction's place.
void StepProblem::start_direction() {
  base_y_.resize(y_.size());
  base_b_ = b_;
  parallel_for(y_.size(), kNodes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      base_y_[i] = y_[i];
      dy_[i] = -gradient_[i];
    }
  });
  for (std::size_t i = 0; i < foreseen_.size(); ++i) dy_[i] -= foreseen_[i];
  for (const Constraint& c : constraints_) dy_[c.node] -= c.blocked * dy_[c.node];
  // A body that nothing touches any more goes back to its free motion.
  for (std::size_t b = 0; b < b_.size(); ++b) db_[b] = -b_[b];
}

// Blocked directions follow the bodies.
void StepProblem::finish_direction() {
  for (const Constraint& c : constraints_) {
    dy_[c.node] -= c.blocked * dy_[c.node];
    if (c.body != kNone) dy_[c.node] += c.blocked * (lever_map(c) * db_[c.body]);
  }
}

}  // namespace retiarius

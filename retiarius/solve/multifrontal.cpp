// The factorisation of the multifrontal solver.
#include "retiarius/solve/multifrontal.hpp"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include "retiarius/base/error.hpp"
#include "retiarius/solve/flush_denormals.hpp"

namespace retiarius {

namespace {

// What a factorisation may cost under an old order, over the pattern that this was made for; beyond
// it a new order is looked for.
constexpr double kMostGrowth = 1.6;

}  // namespace

void MultifrontalSolver::analyse(const BlockPattern& pattern) {
  symbolic_ = analyse_fronts(pattern, trials_);
  first_cost_ = symbolic_.cost;
  use_analysis(pattern);
}

bool MultifrontalSolver::analyse_again(const BlockPattern& pattern) {
  if (analysed_ && static_cast<std::size_t>(pattern.blocks()) == symbolic_.order.size()) {
    Symbolic next = analyse_fronts(pattern, symbolic_.order);
    if (next.cost <= kMostGrowth * first_cost_) {
      symbolic_ = std::move(next);
      use_analysis(pattern);
      return true;
    }
  }
  analyse(pattern);
  return false;
}

void MultifrontalSolver::use_analysis(const BlockPattern& pattern) {
  factored_ = has_parts_ = false;
  lane_columns_ = 0;
  pairs_ = pattern.pairs();
  factor_.resize(symbolic_.factor_size);
  for (AlignedArray* memory : {&serial_, &shared_, &tasks_, &kept_}) memory->resize(0);
  place_kept();
  reserve_updates();
  place_sums();
  position_.resize(symbolic_.order.size());
  for (std::size_t k = 0; k < position_.size(); ++k) {
    position_[symbolic_.order[k]] = static_cast<Index>(k);
  }
  front_of_.resize(position_.size());
  for (std::size_t f = 0; f < symbolic_.fronts.size(); ++f) {
    const auto first = front_of_.begin() + symbolic_.fronts[f].first;
    std::fill_n(first, symbolic_.fronts[f].columns, static_cast<Index>(f));
  }
  analysed_ = true;
}

// All of it, or the fronts that depend on what changed.
bool MultifrontalSolver::factor(const BlockMatrix& matrix, const std::vector<Index>* changed) {
  if (!analysed_) throw Error("factor() needs analyse() before it");
  if (matrix.diagonal.size() != symbolic_.order.size() ||
      matrix.below.size() != static_cast<std::size_t>(pairs_)) {
    throw Error(
        fmt::format("the matrix has {} blocks and {} pairs, the pattern that was analysed "
                    "{} and {}; analyse its pattern first",
                    matrix.diagonal.size(), matrix.below.size(), symbolic_.order.size(), pairs_));
  }
  lane_columns_ = 0;
  const bool again = changed && has_parts_;
  is_changed_.assign(symbolic_.fronts.size(), again ? 0 : 1);
  if (again) mark_changes(*changed);
  matrix_ = &matrix;
  kernels_ = &kernels::active();
  reserve_updates();
  side_by_side_ = parallel();
  factored_ = side_by_side_ ? factor_parallel() : factor_serial();
  matrix_ = nullptr;
  has_parts_ = keeps_parts_ && factored_;
  return factored_;
}

// A front depends on what is in its pivot columns and on its children, which come before it.
void MultifrontalSolver::mark_changes(const std::vector<Index>& changed) {
  for (const Index block : changed) is_changed_[front_of_[position_[block]]] = 1;
  for (std::size_t f = 0; f < symbolic_.fronts.size(); ++f) {
    const Index parent = symbolic_.fronts[f].parent;
    if (is_changed_[f] && parent != kNone) is_changed_[parent] = 1;
  }
}

void MultifrontalSolver::place_kept() {
  kept_updates_.clear();
  kept_size_ = 0;
  for (const Front& front : symbolic_.fronts) {
    kept_updates_.push_back(kept_size_);
    kept_size_ +=
        static_cast<std::size_t>(front.update_ld) * static_cast<std::size_t>(front.rows_below());
  }
}

// Does nothing when the memory is there already.
void MultifrontalSolver::reserve_updates() {
  if (keeps_parts_) {
    kept_.resize(kept_size_);
  } else if (parallel()) {
    shared_.resize(symbolic_.shared_size);
    tasks_.resize(symbolic_.tasks_size);
  } else {
    serial_.resize(symbolic_.update_size);
  }
}

bool MultifrontalSolver::factor_serial() {
  const FlushDenormals flush;
  for (std::size_t f = 0; f < symbolic_.fronts.size(); ++f) {
    if (is_changed_[f] && !factor_front(symbolic_.fronts[f], nullptr, false)) return false;
  }
  return true;
}

bool MultifrontalSolver::factor_parallel() {
  failed_ = false;
  tbb::task_group group;
  for (Index f = 0; f < static_cast<Index>(symbolic_.fronts.size()); ++f) {
    const Front& front = symbolic_.fronts[f];
    if (front.parent != kNone) continue;
    group.run([this, f] { factor_above(f); });
  }
  group.wait();
  return !failed_;
}

void MultifrontalSolver::factor_above(Index f) {
  const Front& front = symbolic_.fronts[f];
  if (!is_changed_[f]) return;
  if (front.task != kNone) return factor_task(front.task);
  tbb::task_group group;
  for (std::size_t c = front.child_begin; c < front.child_end; ++c) {
    const Index child = symbolic_.children[c];
    group.run([this, child] { factor_above(child); });
  }
  group.wait();
  const FlushDenormals flush;
  if (!failed_ && !factor_front(front, tasks_.data(), true)) failed_ = true;
}

void MultifrontalSolver::factor_task(Index t) {
  const FlushDenormals flush;
  const FrontTask& task = symbolic_.tasks[t];
  for (Index f = task.begin; f < task.end && !failed_; ++f) {
    if (is_changed_[f] && !factor_front(symbolic_.fronts[f], tasks_.data() + task.offset, false))
      failed_ = true;
  }
}

bool MultifrontalSolver::factor_front(const Front& front, double* memory, bool spread) {
  double* panel = factor_.data() + front.panel;
  double* update = update_of(front, memory);
  assemble(front, panel);
  // The children's parts for the panel come first; those for the update follow its own product,
  // which then need not read what it writes.
  add_children(front, panel, update, memory, Part::panel);
  if (!kernels_->factor_panel(panel, front.ld, front.pivots())) return false;
  if (front.below == 0) return true;
  make_update(front, panel, update, spread);
  add_children(front, panel, update, memory, Part::update);
  return true;
}

void MultifrontalSolver::assemble(const Front& front, double* panel) const {
  const std::size_t ld = static_cast<std::size_t>(front.ld);
  std::memset(panel, 0, sizeof(double) * ld * static_cast<std::size_t>(front.pivots()));
  for (Index k = 0; k < front.columns; ++k) {
    const double* from = matrix_->diagonal[symbolic_.order[front.first + k]].data();
    double* to = panel + 3L * k * (ld + 1);
    for (int c = 0; c < 3; ++c, to += ld, from += 3) std::memcpy(to, from, 3 * sizeof(double));
  }
  for (std::size_t i = front.straight; i < front.transposed; ++i) {
    const BlockCopy& copy = symbolic_.copies[i];
    const double* from = matrix_->below[copy.slot].data();
    double* to = panel + copy.offset;
    for (int c = 0; c < 3; ++c, to += ld, from += 3) std::memcpy(to, from, 3 * sizeof(double));
  }
  for (std::size_t i = front.transposed; i < front.copies_end; ++i) {
    const BlockCopy& copy = symbolic_.copies[i];
    const double* from = matrix_->below[copy.slot].data();
    double* to = panel + copy.offset;
    for (int c = 0; c < 3; ++c, to += ld, ++from) {
      to[0] = from[0];
      to[1] = from[3];
      to[2] = from[6];
    }
  }
}

void MultifrontalSolver::add_children(const Front& front, double* panel, double* update,
                                      double* memory, Part part) {
  for (std::size_t c = front.child_begin; c < front.child_end; ++c) {
    const Front& child = symbolic_.fronts[symbolic_.children[c]];
    const Index begin = part == Part::panel ? 0 : child.into_panel;
    const Index end = part == Part::panel ? child.into_panel : child.below;
    kernels_->extend_add({update_of(child, memory), child.update_ld, begin, end,
                          symbolic_.targets.data() + child.rows,
                          symbolic_.runs.data() + child.run_begin,
                          static_cast<int>(child.run_end - child.run_begin), panel, front.ld,
                          front.columns, front.pivot_rows, update, front.update_ld});
  }
}

void MultifrontalSolver::make_update(const Front& front, const double* panel, double* update,
                                     bool spread) const {
  constexpr int kStrip = 96;      // rows; a multiple of every kernel's tile
  constexpr double kLarge = 1e6;  // products, from which on sharing the work pays
  const int u = front.rows_below();
  const double* below = panel + front.pivot_rows;
  const auto rows = [&](int begin, int end) {
    kernels_->update(below, front.ld, front.pivots(), update, front.update_ld, u, begin, end);
  };
  if (!spread || 0.5 * front.pivots() * u * u < kLarge) return rows(0, front.update_ld);
  // Isolated, lest the waiting thread takes up other work in its present mode.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(0, (front.update_ld + kStrip - 1) / kStrip, [&](int strip) {
      const FlushDenormals flush;
      rows(strip * kStrip, std::min(front.update_ld, (strip + 1) * kStrip));
    });
  });
}

std::unique_ptr<LinearSolver> make_multifrontal_solver() {
  return std::make_unique<MultifrontalSolver>();
}

}  // namespace retiarius

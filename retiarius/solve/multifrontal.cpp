// Multifrontal Cholesky factorisation in 3x3 blocks (J. W. H. Liu, The multifrontal method for
// sparse matrix solution: theory and practice, SIAM Review 34, 1992).
//
// A front takes the matrix's entries of its pivot columns and its children's updates, always in the
// same order, so that the factor does not depend on which thread computed what.
#include <algorithm>
#include <atomic>
#include <cstring>
#include <memory>
#include <ranges>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/solve/aligned_array.hpp"
#include "retiarius/solve/flush_denormals.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "retiarius/solve/symbolic.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kSmallFactor = 100000;  // scalars that one thread reads as quickly as several

class MultifrontalSolver : public LinearSolver {
 public:
  std::string_view name() const override { return "multifrontal"; }

  void analyse(const BlockPattern& pattern) override;
  void expect_changes(bool soon) override { trials_ = soon ? 1 : kOrderTrials; }
  bool factor(const BlockMatrix& matrix) override { return factor(matrix, nullptr); }
  void keep_parts(bool keep) override {
    keeps_parts_ = keep;
    has_parts_ = has_parts_ && keep;
  }
  bool refactor(const BlockMatrix& matrix, const std::vector<Index>& changed) override {
    return factor(matrix, &changed);
  }
  void solve(std::vector<Vec3>& x) const override;

  double factor_entries() const override { return symbolic_.entries; }
  double factor_flops() const override { return symbolic_.flops; }

 private:
  bool factor(const BlockMatrix& matrix, const std::vector<Index>* changed);
  void mark_changes(const std::vector<Index>& changed);
  bool parallel() const { return threads() > 1 && symbolic_.tasks.size() > 1; }
  void place_kept();
  void reserve_updates();
  bool factor_serial();
  bool factor_parallel();
  void factor_above(Index f);
  void factor_task(Index task);
  bool factor_front(const Front& front, double* memory, bool spread);
  void assemble(const Front& front, double* panel) const;
  enum class Part { panel, update };
  void add_children(const Front& front, double* panel, double* update, double* memory, Part part);
  void make_update(const Front& front, const double* panel, double* update, bool spread) const;
  void place_sums();
  void add_sums(double* all, std::size_t width) const;
  template <class Body>
  void each_task(const Body& body) const;
  void forward(const Front& front, double* all, double* w) const;
  void backward(const Front& front, double* all, double* w) const;
  void solve_one(Vec3* x) const;
  void solve_together(Vec3* x, std::size_t count) const;

  // `memory` is the task's; one thread has its own.
  double* update_of(const Front& front, double* memory) {
    if (keeps_parts_) return kept_.data() + kept_updates_[&front - symbolic_.fronts.data()];
    if (!side_by_side_) return serial_.data() + front.update;
    return (front.update_shared ? shared_.data() : memory) + front.task_update;
  }

  int trials_ = kOrderTrials;
  Symbolic symbolic_;
  std::vector<Index> position_;  // of each block in the order of elimination
  std::vector<Index> front_of_;  // of each position, the front that eliminates it
  Index pairs_ = 0;
  bool analysed_ = false, factored_ = false;
  AlignedArray factor_, serial_, shared_, tasks_;
  bool keeps_parts_ = false;
  AlignedArray kept_;  // all updates
  std::size_t kept_size_ = 0;
  std::vector<std::size_t> kept_updates_;  // where each front's begins
  bool has_parts_ = false;
  std::vector<char> is_changed_;            // whether each front depends on a block that changed
  mutable AlignedArray front_vector_;       // of the top, then one a task
  std::vector<std::size_t> front_vectors_;  // where those of the tasks begin
  std::vector<Index> sum_rows_;             // see place_sums()
  std::vector<Index> sum_starts_;           // of each task's own places
  mutable std::vector<Vec3> permuted_;      // the blocks, then the tasks' own places
  mutable AlignedArray lanes_;              // interleaved right-hand sides, once there were several
  const BlockMatrix* matrix_ = nullptr;     // while factor() runs
  const kernels::KernelTable* kernels_ = nullptr;
  bool side_by_side_ = false;  // by tasks
  std::atomic<bool> failed_ = false;
};

void MultifrontalSolver::analyse(const BlockPattern& pattern) {
  factored_ = has_parts_ = false;
  symbolic_ = analyse_fronts(pattern, trials_);
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

void MultifrontalSolver::solve(std::vector<Vec3>& x) const {
  if (!factored_) throw Error("solve() needs a successful factor() before it");
  const std::size_t blocks = symbolic_.order.size();
  if (blocks == 0 ? !x.empty() : x.size() % blocks != 0) {
    throw Error(fmt::format("a right-hand side of {} blocks does not fit a matrix of {}", x.size(),
                            blocks));
  }
  const std::size_t most = kernels::kLanes * blocks;
  for (std::size_t start = 0; start < x.size(); start += most) {
    const std::size_t count = std::min(most, x.size() - start) / blocks;
    if (count == 1) {
      solve_one(x.data() + start);
    } else {
      solve_together(x.data() + start, count);
    }
  }
}

// Tasks one after the other or side by side, whatever is quicker; they write to places of their
// own.
template <class Body>
void MultifrontalSolver::each_task(const Body& body) const {
  const auto range = [&](std::size_t begin, std::size_t end) {
    const FlushDenormals flush;
    for (std::size_t t = begin; t < end; ++t) body(t);
  };
  if (symbolic_.factor_size < kSmallFactor) return range(0, symbolic_.tasks.size());
  parallel_for(symbolic_.tasks.size(), 1, range);
}

// Where the sweeps add what a front's pivots do to the rows below: within a task, rows beyond it
// have a place for the task alone, behind the blocks' own.
void MultifrontalSolver::place_sums() {
  sum_rows_ = symbolic_.rows;
  sum_starts_.clear();
  front_vectors_.clear();
  auto end = static_cast<Index>(symbolic_.order.size());
  std::size_t vectors = static_cast<std::size_t>(symbolic_.largest_ld);
  for (const FrontTask& task : symbolic_.tasks) {
    const Front& root = symbolic_.fronts[task.end - 1];
    const Index limit = root.first + root.columns;
    const auto first = symbolic_.rows.begin() + static_cast<std::ptrdiff_t>(root.rows);
    int most = 0;
    for (Index f = task.begin; f < task.end; ++f) {
      const Front& front = symbolic_.fronts[f];
      most = std::max(most, front.ld);
      for (Index b = 0; b < front.below; ++b) {
        Index& row = sum_rows_[front.rows + b];
        if (row < limit) continue;
        row = end + static_cast<Index>(std::lower_bound(first, first + root.below, row) - first);
      }
    }
    sum_starts_.push_back(end);
    end += root.below;
    front_vectors_.push_back(vectors);
    vectors += static_cast<std::size_t>(most);
  }
  permuted_.resize(static_cast<std::size_t>(end));
  front_vector_.resize(vectors);
}

// What the tasks have for rows beyond them, in the order of the tasks; `width` numbers a block.
void MultifrontalSolver::add_sums(double* all, std::size_t width) const {
  for (std::size_t t = 0; t < symbolic_.tasks.size(); ++t) {
    const Front& root = symbolic_.fronts[symbolic_.tasks[t].end - 1];
    const double* from = all + width * static_cast<std::size_t>(sum_starts_[t]);
    for (Index b = 0; b < root.below; ++b) {
      double* const to = all + width * static_cast<std::size_t>(symbolic_.rows[root.rows + b]);
      for (std::size_t i = 0; i < width; ++i) to[i] += *from++;
    }
  }
}

void MultifrontalSolver::forward(const Front& front, double* all, double* w) const {
  double* const own = all + 3L * front.first;
  const auto pivots = static_cast<std::size_t>(front.pivots());
  std::memcpy(w, own, sizeof(double) * pivots);
  std::memset(w + pivots, 0, sizeof(double) * (static_cast<std::size_t>(front.ld) - pivots));
  kernels::active().forward(factor_.data() + front.panel, front.ld, front.pivots(), w, own);
  const double* from = w + front.pivot_rows;
  for (Index b = 0; b < front.below; ++b, from += 3) {
    double* to = all + 3L * sum_rows_[front.rows + b];
    for (int i = 0; i < 3; ++i) to[i] += from[i];
  }
}

void MultifrontalSolver::backward(const Front& front, double* all, double* w) const {
  std::memset(w, 0, sizeof(double) * static_cast<std::size_t>(front.pivot_rows));
  double* to = w + front.pivot_rows;
  for (Index b = 0; b < front.below; ++b, to += 3) {
    const double* from = all + 3L * symbolic_.rows[front.rows + b];
    for (int i = 0; i < 3; ++i) to[i] = from[i];
  }
  std::fill(to, w + front.ld, 0.0);
  kernels::active().backward(factor_.data() + front.panel, front.ld, front.pivots(), w,
                             all + 3L * front.first);
}

void MultifrontalSolver::solve_one(Vec3* x) const {
  const FlushDenormals flush;
  const std::vector<Front>& fronts = symbolic_.fronts;
  const std::size_t blocks = symbolic_.order.size();
  for (std::size_t k = 0; k < blocks; ++k) permuted_[k] = x[symbolic_.order[k]];
  std::fill(permuted_.begin() + static_cast<std::ptrdiff_t>(blocks), permuted_.end(), Vec3::Zero());
  double* const all = permuted_.empty() ? nullptr : permuted_.front().data();
  each_task([&](std::size_t t) {
    const FrontTask& task = symbolic_.tasks[t];
    double* const w = front_vector_.data() + front_vectors_[t];
    for (Index f = task.begin; f < task.end; ++f) forward(fronts[f], all, w);
  });
  add_sums(all, 3);
  for (const Index f : symbolic_.top) forward(fronts[f], all, front_vector_.data());
  for (const Index f : std::views::reverse(symbolic_.top))
    backward(fronts[f], all, front_vector_.data());
  each_task([&](std::size_t t) {
    const FrontTask& task = symbolic_.tasks[t];
    double* const w = front_vector_.data() + front_vectors_[t];
    for (Index f = task.end; f-- > task.begin;) backward(fronts[f], all, w);
  });
  for (std::size_t k = 0; k < blocks; ++k) x[symbolic_.order[k]] = permuted_[k];
}

// At most kLanes right-hand sides, one after the other in x. Lanes to spare are zero.
void MultifrontalSolver::solve_together(Vec3* x, std::size_t count) const {
  constexpr std::size_t kLanes = kernels::kLanes;
  const FlushDenormals flush;
  const std::size_t blocks = symbolic_.order.size();
  lanes_.resize(3 * kLanes * permuted_.size());
  // In the order of x: the rows of lanes are whole cache lines wherever they are.
  for (std::size_t i = 0; i < blocks; ++i) {
    double* const to = lanes_.data() + 3 * kLanes * static_cast<std::size_t>(position_[i]);
    for (std::size_t c = 0; c < count; ++c) {
      for (int k = 0; k < 3; ++k) to[k * kLanes + c] = x[c * blocks + i][k];
    }
    for (std::size_t c = count; c < kLanes; ++c) {
      for (int k = 0; k < 3; ++k) to[k * kLanes + c] = 0.0;
    }
  }
  double* const all = lanes_.data();
  std::fill(all + 3 * kLanes * blocks, all + 3 * kLanes * permuted_.size(), 0.0);
  const auto sweep = [&](Index f, const std::vector<Index>& rows) {
    const Front& front = symbolic_.fronts[f];
    return kernels::Sweep{factor_.data() + front.panel,
                          front.ld,
                          front.pivots(),
                          front.pivot_rows,
                          rows.data() + front.rows,
                          front.below,
                          all + 3 * kLanes * static_cast<std::size_t>(front.first),
                          all};
  };
  const kernels::KernelTable& kernel = kernels::active();
  each_task([&](std::size_t t) {
    const FrontTask& task = symbolic_.tasks[t];
    for (Index f = task.begin; f < task.end; ++f) kernel.forward_lanes(sweep(f, sum_rows_));
  });
  add_sums(all, 3 * kLanes);
  for (const Index f : symbolic_.top) kernel.forward_lanes(sweep(f, sum_rows_));
  for (const Index f : std::views::reverse(symbolic_.top))
    kernel.backward_lanes(sweep(f, symbolic_.rows));
  each_task([&](std::size_t t) {
    const FrontTask& task = symbolic_.tasks[t];
    for (Index f = task.end; f-- > task.begin;) kernel.backward_lanes(sweep(f, symbolic_.rows));
  });
  for (std::size_t i = 0; i < blocks; ++i) {
    const double* const from = lanes_.data() + 3 * kLanes * static_cast<std::size_t>(position_[i]);
    for (std::size_t c = 0; c < count; ++c) {
      for (int k = 0; k < 3; ++k) x[c * blocks + i][k] = from[k * kLanes + c];
    }
  }
}

}  // namespace

std::unique_ptr<LinearSolver> make_multifrontal_solver() {
  return std::make_unique<MultifrontalSolver>();
}

}  // namespace retiarius

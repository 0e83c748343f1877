// Solutions with the multifrontal solver's factor.
#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/solve/flush_denormals.hpp"
#include "retiarius/solve/multifrontal.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kLanes = kernels::kLanes;
constexpr std::size_t kLine = 3 * kLanes;     // numbers of a block in all lanes
constexpr std::size_t kSmallFactor = 100000;  // scalars that one thread reads as quickly as several

}  // namespace

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

// What permuted_ holds, in the order of elimination, becomes L^-1 of it.
void MultifrontalSolver::forward_all() const {
  std::fill(permuted_.begin() + static_cast<std::ptrdiff_t>(symbolic_.order.size()),
            permuted_.end(), Vec3::Zero());
  if (permuted_.empty()) return;
  double* const all = permuted_.front().data();
  each_task([&](std::size_t t) {
    const FrontTask& task = symbolic_.tasks[t];
    double* const w = front_vector_.data() + front_vectors_[t];
    for (Index f = task.begin; f < task.end; ++f) forward(symbolic_.fronts[f], all, w);
  });
  add_sums(all, 3);
  for (const Index f : symbolic_.top) forward(symbolic_.fronts[f], all, front_vector_.data());
}

// ... and L^-T of it.
void MultifrontalSolver::backward_all() const {
  if (permuted_.empty()) return;
  double* const all = permuted_.front().data();
  for (std::size_t k = symbolic_.top.size(); k-- > 0;)
    backward(symbolic_.fronts[symbolic_.top[k]], all, front_vector_.data());
  each_task([&](std::size_t t) {
    const FrontTask& task = symbolic_.tasks[t];
    double* const w = front_vector_.data() + front_vectors_[t];
    for (Index f = task.end; f-- > task.begin;) backward(symbolic_.fronts[f], all, w);
  });
}

void MultifrontalSolver::check_size(std::size_t blocks) const {
  if (!factored_) throw Error("solve() needs a successful factor() before it");
  if (blocks != symbolic_.order.size()) {
    throw Error(fmt::format("a right-hand side of {} blocks does not fit a matrix of {}", blocks,
                            symbolic_.order.size()));
  }
}

void MultifrontalSolver::solve(std::vector<Vec3>& x) const {
  check_size(x.size());
  const FlushDenormals flush;
  for (std::size_t k = 0; k < x.size(); ++k) permuted_[k] = x[symbolic_.order[k]];
  forward_all();
  backward_all();
  for (std::size_t k = 0; k < x.size(); ++k) x[symbolic_.order[k]] = permuted_[k];
}

// Places of consecutive reached fronts, as ranges.
template <class Body>
void MultifrontalSolver::for_reached(const Body& body) const {
  for (std::size_t f = 0; f < reached_.size(); ++f) {
    if (!reached_[f]) continue;
    const auto begin = static_cast<std::size_t>(symbolic_.fronts[f].first);
    while (f + 1 < reached_.size() && reached_[f + 1]) ++f;
    const Front& last = symbolic_.fronts[f];
    body(begin, static_cast<std::size_t>(last.first) + static_cast<std::size_t>(last.columns));
  }
}

// The fronts of the border's nodes, and all that are above these: elsewhere its columns stay zero.
void MultifrontalSolver::mark_reached(const std::vector<BorderColumns>& border) const {
  reached_.assign(symbolic_.fronts.size(), 0);
  for (const BorderColumns& b : border)
    for (const Index node : *b.nodes) reached_[front_of_[position_[node]]] = 1;
  for (std::size_t f = 0; f < reached_.size(); ++f) {
    const Index parent = symbolic_.fronts[f].parent;
    if (reached_[f] && parent != kNone) reached_[parent] = 1;
  }
}

// Zero in all lanes where fronts are reached, but for the border's columns.
void MultifrontalSolver::fill_lanes(const std::vector<BorderColumns>& border) const {
  const std::size_t blocks = symbolic_.order.size();
  const auto clear = [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = 0; g <= lane_columns_ / kLanes; ++g)
      std::fill(lanes_of(g) + kLine * begin, lanes_of(g) + kLine * end, 0.0);
  };
  for_reached(clear);
  clear(blocks, half_.size());
  for (std::size_t b = 0; b < border.size(); ++b) {
    for (std::size_t c = 0; c < 6; ++c) {
      const std::size_t column = 6 * b + c;
      double* const first = lanes_of(column / kLanes) + column % kLanes;
      for (std::size_t i = 0; i < border[b].nodes->size(); ++i) {
        const auto place = static_cast<std::size_t>(position_[(*border[b].nodes)[i]]);
        for (std::size_t k = 0; k < 3; ++k)
          first[kLine * place + k * kLanes] =
              (*border[b].rows)[i](static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(k));
      }
    }
  }
}

// Forward substitution by one front: of r alone where the border does not reach it; else r goes on
// in a lane behind the border's.
void MultifrontalSolver::forward_half(Index f, double* w) const {
  const Front& front = symbolic_.fronts[f];
  if (!reached_[f]) return forward(front, half_.front().data(), w);
  const std::size_t last = lane_columns_ / kLanes;
  const auto first = static_cast<std::size_t>(front.first);
  double* to = lanes_of(last) + kLine * first + lane_columns_ % kLanes;
  const double* const own = half_[first].data();
  for (int k = 0; k < front.pivots(); ++k, to += kLanes) *to += own[k];
  for (std::size_t g = 0; g <= last; ++g) {
    double* const all = lanes_of(g);
    kernels::active().forward_lanes({factor_.data() + front.panel, front.ld, front.pivots(),
                                     front.pivot_rows, sum_rows_.data() + front.rows, front.below,
                                     all + kLine * first, all});
  }
}

// With A = L L^T all that is wanted of A^-1 B are the products with B, (L^-1 B)^T L^-1 [B r].
void MultifrontalSolver::begin_bordered(const std::vector<BorderColumns>& border,
                                        const std::vector<Vec3>& r,
                                        Eigen::MatrixXd& products) const {
  check_size(r.size());
  const FlushDenormals flush;
  mark_reached(border);
  lane_columns_ = 6 * border.size();
  half_.resize(permuted_.size());
  lanes_.resize((lane_columns_ / kLanes + 1) * kLine * half_.size());
  for (std::size_t k = 0; k < r.size(); ++k) half_[k] = r[symbolic_.order[k]];
  std::fill(half_.begin() + static_cast<std::ptrdiff_t>(r.size()), half_.end(), Vec3::Zero());
  fill_lanes(border);
  each_task([&](std::size_t t) {
    const FrontTask& task = symbolic_.tasks[t];
    double* const w = front_vector_.data() + front_vectors_[t];
    for (Index f = task.begin; f < task.end; ++f) forward_half(f, w);
  });
  if (!half_.empty()) add_sums(half_.front().data(), 3);
  for (std::size_t g = 0; g <= lane_columns_ / kLanes; ++g) add_sums(lanes_of(g), kLine);
  for (const Index f : symbolic_.top) forward_half(f, front_vector_.data());
  find_products(products);
}

void MultifrontalSolver::find_products(Eigen::MatrixXd& products) const {
  const auto columns = static_cast<Eigen::Index>(lane_columns_);
  products.resize(columns, columns + 1);
  for (std::size_t g = 0; g <= lane_columns_ / kLanes; ++g) {
    for (std::size_t other = 0; other <= lane_columns_ / kLanes; ++other) {
      alignas(64) double sums[kLanes * kLanes] = {};
      for_reached([&](std::size_t begin, std::size_t end) {
        kernels::active().products(lanes_of(g) + kLine * begin, lanes_of(other) + kLine * begin,
                                   3 * static_cast<long>(end - begin), sums);
      });
      for (std::size_t i = 0; i < kLanes; ++i) {
        for (std::size_t j = 0; j < kLanes; ++j) {
          const auto row = static_cast<Eigen::Index>(g * kLanes + i);
          const auto column = static_cast<Eigen::Index>(other * kLanes + j);
          if (row < columns && column <= columns) products(row, column) = sums[i * kLanes + j];
        }
      }
    }
  }
}

void MultifrontalSolver::end_bordered(const Eigen::VectorXd& c, std::vector<Vec3>& x) const {
  if (c.size() == 0 || static_cast<std::size_t>(c.size()) != lane_columns_)
    throw Error("end_bordered() needs begin_bordered() with as many columns before it");
  const FlushDenormals flush;
  x.resize(symbolic_.order.size());
  std::copy(half_.begin(), half_.begin() + static_cast<std::ptrdiff_t>(x.size()),
            permuted_.begin());
  for_reached([&](std::size_t begin, std::size_t end) {
    std::fill(permuted_.begin() + static_cast<std::ptrdiff_t>(begin),
              permuted_.begin() + static_cast<std::ptrdiff_t>(end), Vec3::Zero());
    for (std::size_t g = 0; g <= lane_columns_ / kLanes; ++g) {
      double share[kLanes] = {};
      for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t column = g * kLanes + i;
        if (column < lane_columns_) share[i] = -c[static_cast<Eigen::Index>(column)];
        if (column == lane_columns_) share[i] = 1.0;
      }
      const double* from = lanes_of(g) + kLine * begin;
      for (std::size_t k = begin; k < end; ++k)
        for (int d = 0; d < 3; ++d, from += kLanes)
          for (std::size_t i = 0; i < kLanes; ++i) permuted_[k][d] += share[i] * from[i];
    }
  });
  backward_all();
  for (std::size_t k = 0; k < x.size(); ++k) x[symbolic_.order[k]] = permuted_[k];
}

}  // namespace retiarius

#include "retiarius/base/block_matrix.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/parallel.hpp"

namespace retiarius {

void BlockPattern::couple(Index i, Index j) {
  if (i < 0 || j < 0 || i >= blocks_ || j >= blocks_) {
    throw Error(
        fmt::format("cannot couple blocks {} and {}: the pattern has {} blocks", i, j, blocks_));
  }
  if (i != j) added_.emplace_back(std::min(i, j), std::max(i, j));
}

void BlockPattern::finish() {
  // What an earlier finish() left is kept, so that a pattern can grow.
  if (!starts_.empty()) {
    for (Index c = 0; c < blocks_; ++c) {
      for (Index k = starts_[c]; k < starts_[c + 1]; ++k) added_.emplace_back(c, rows_[k]);
    }
  }
  std::sort(added_.begin(), added_.end());
  added_.erase(std::unique(added_.begin(), added_.end()), added_.end());

  starts_.assign(static_cast<std::size_t>(blocks_) + 1, 0);
  rows_.clear();
  rows_.reserve(added_.size());
  for (const auto& [column, row] : added_) {
    ++starts_[column + 1];
    rows_.push_back(row);
  }
  for (Index c = 0; c < blocks_; ++c) starts_[c + 1] += starts_[c];
  added_.clear();
  added_.shrink_to_fit();
}

Index BlockPattern::slot(Index i, Index j) const {
  const Index column = std::min(i, j);
  const Index row = std::max(i, j);
  if (starts_.empty()) throw Error("the pattern is used before finish()");
  if (column >= 0 && row < blocks_) {
    const auto begin = rows_.begin() + starts_[column];
    const auto end = rows_.begin() + starts_[column + 1];
    const auto found = std::lower_bound(begin, end, row);
    if (found != end && *found == row) return static_cast<Index>(found - rows_.begin());
  }
  throw Error(
      fmt::format("blocks {} and {} are not coupled in the pattern of {} blocks", i, j, blocks_));
}

void BlockMatrix::reset(const BlockPattern& p) {
  pattern = &p;
  diagonal.resize(static_cast<std::size_t>(p.blocks()));
  below.resize(static_cast<std::size_t>(p.pairs()));
  set_zero();
}

void BlockMatrix::set_zero() {
  constexpr std::size_t kGrain = 4096;
  for (std::vector<Mat3>* blocks : {&diagonal, &below}) {
    parallel_for(blocks->size(), kGrain, [&](std::size_t begin, std::size_t end) {
      std::fill_n(blocks->data()->data() + 9 * begin, 9 * (end - begin), 0.0);
    });
  }
}

void BlockMatrix::multiply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const {
  const Index blocks = pattern->blocks();
  const std::vector<Index>& starts = pattern->starts();
  const std::vector<Index>& rows = pattern->rows();
  y.resize(static_cast<std::size_t>(blocks));
  for (Index i = 0; i < blocks; ++i) y[i] = diagonal[i] * x[i];
  for (Index c = 0; c < blocks; ++c) {
    for (Index k = starts[c]; k < starts[c + 1]; ++k) {
      y[rows[k]] += below[k] * x[c];
      y[c] += below[k].transpose() * x[rows[k]];
    }
  }
}

}  // namespace retiarius

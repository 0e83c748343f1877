// A symmetric sparse matrix of 3x3 blocks with a fixed pattern that may be replaced by a larger
// one.
#pragma once

#include <utility>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// Which blocks below the diagonal may be nonzero. Row r, column c with r > c.
class BlockPattern {
 public:
  explicit BlockPattern(Index blocks = 0) : blocks_(blocks) {}

  // Adds the pair (i, j), in any order; the diagonal is always there.
  void couple(Index i, Index j);

  // Sorts and removes repetitions; needed before the pattern is used.
  void finish();

  Index blocks() const { return blocks_; }
  Index pairs() const { return static_cast<Index>(rows_.size()); }

  // Column-compressed: rows of column c are rows()[starts()[c]] ... ascending, all > c.
  const std::vector<Index>& starts() const { return starts_; }
  const std::vector<Index>& rows() const { return rows_; }

  // Position of the pair in rows(); the order of i and j does not matter. Throws Error if absent.
  Index slot(Index i, Index j) const;

 private:
  Index blocks_;
  std::vector<std::pair<Index, Index>> added_;  // (column, row)
  std::vector<Index> starts_, rows_;
};

// Values on a pattern: block `slot` holds rows 3r.., columns 3c.. of the matrix.
struct BlockMatrix {
  const BlockPattern* pattern = nullptr;
  std::vector<Mat3> diagonal;
  std::vector<Mat3> below;  // indexed by slot

  void reset(const BlockPattern& p);  // sizes it and sets it to zero
  void set_zero();

  // y = A x
  void multiply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const;
};

}  // namespace retiarius

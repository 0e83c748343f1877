// The lower triangle of a block matrix as compressed columns of scalars.
#pragma once

#include <vector>

#include "retiarius/base/block_matrix.hpp"

namespace retiarius::benchmarks {

// The pattern is made once; copying values into it costs one pass, so that opponents do not pay for
// our form of the matrix.
class ScalarLower {
 public:
  ScalarLower() = default;
  explicit ScalarLower(const BlockPattern& pattern);

  void copy(const BlockMatrix& matrix);

  int size() const { return static_cast<int>(starts_.size()) - 1; }
  std::vector<int>& starts() { return starts_; }
  std::vector<int>& rows() { return rows_; }
  std::vector<double>& values() { return values_; }

 private:
  std::vector<int> starts_, rows_;
  std::vector<double> values_;
};

}  // namespace retiarius::benchmarks

#include "benchmarks/opponents/scalar_lower.hpp"

namespace retiarius::benchmarks {

ScalarLower::ScalarLower(const BlockPattern& pattern) {
  starts_.push_back(0);
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (int b = 0; b < 3; ++b) {
      for (int a = b; a < 3; ++a) rows_.push_back(3 * c + a);
      for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k)
        for (int a = 0; a < 3; ++a) rows_.push_back(3 * pattern.rows()[k] + a);
      starts_.push_back(static_cast<int>(rows_.size()));
    }
  }
  values_.resize(rows_.size());
}

void ScalarLower::copy(const BlockMatrix& matrix) {
  const BlockPattern& pattern = *matrix.pattern;
  double* to = values_.data();
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (int b = 0; b < 3; ++b) {
      for (int a = b; a < 3; ++a) *to++ = matrix.diagonal[c](a, b);
      for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k)
        for (int a = 0; a < 3; ++a) *to++ = matrix.below[k](a, b);
    }
  }
}

}  // namespace retiarius::benchmarks

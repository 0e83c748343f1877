// Shares and intervals: how well a number of runs tells a probability.
#pragma once

#include <cstdint>

namespace retiarius {

struct Interval {
  double low = 0.0, high = 0.0;
  double width() const { return high - low; }
  bool contains(double value) const { return low <= value && value <= high; }
};

// The value that a standard normal variable stays below with probability p, 0 < p < 1; accurate to
// a few units of rounding. Throws Error outside of that range.
double normal_quantile(double p);

// Confidence interval of a probability of which `successes` of `trials` independent trials came
// out: the score interval (Wilson, J. Am. Stat. Assoc. 22, 1927). Its ends lie within 0 to 1 and
// it has a width even when all or none succeed. No trials: 0 to 1. Throws Error for more successes
// than trials, for negative counts and a confidence outside of 0 to 1.
Interval wilson_interval(std::int64_t successes, std::int64_t trials, double confidence = 0.95);

}  // namespace retiarius

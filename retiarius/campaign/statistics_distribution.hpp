// How the values of an input or of a measure are spread.
#pragma once

#include <cstddef>
#include <vector>

namespace retiarius {

// Of the values that are there; NaN counts as missing. Without values all numbers are NaN.
struct SampleDistribution {
  std::size_t count = 0, missing = 0;
  double mean = 0.0;
  double deviation = 0.0;  // standard deviation of the sample (n - 1); NaN for one value
  double least = 0.0, greatest = 0.0;
  double q05 = 0.0, q25 = 0.0, median = 0.0, q75 = 0.0, q95 = 0.0;
};
SampleDistribution distribution(const std::vector<double>& values);

// Quantile of ascending values without NaN, 0 <= p <= 1, linear between order statistics
// (definition 7 of Hyndman & Fan, Am. Stat. 50, 1996). NaN without values.
double quantile(const std::vector<double>& ascending, double p);

// Bins of equal width over the range of the values. `edges` has one more entry than `counts`; the
// last bin holds its upper edge.
struct Histogram {
  std::vector<double> edges;
  std::vector<std::size_t> counts;
  // The bin that holds the value; edges.size() for NaN and for what lies outside.
  std::size_t bin(double value) const;
};

// With `bins` bins, or for 0 with as many as Freedman and Diaconis (1981) would take, from 5 to 40;
// few distinct values (such as of a grid or a count) get a bin each. Without values: no bins.
Histogram histogram(const std::vector<double>& values, std::size_t bins = 0);

}  // namespace retiarius

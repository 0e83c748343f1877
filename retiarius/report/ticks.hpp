// Round numbers along an axis and how they are written.
#pragma once

#include <string>
#include <vector>

namespace retiarius {

// An axis from `low` to `high` (low < high) with ticks at multiples of a round step.
struct Axis {
  double low = 0.0, high = 1.0;
  std::vector<double> ticks;
  std::vector<std::string> labels;
  int exponent = 0;  // labels are in units of 10^exponent, a multiple of three
};

// The axis that holds all values from low to high with about `count` ticks at multiples of 1, 2 or
// 5 times a power of ten. `loose` moves the ends to ticks, otherwise they stay at the data. A range
// of zero length is widened.
Axis nice_axis(double low, double high, int count, bool loose);

// "10^-12" with superscript digits, for labels; empty for exponent 0.
std::string power_of_ten(int exponent);

}  // namespace retiarius

// An axis of a printed chart: linear or logarithmic, with labelled and with minor ticks.
#pragma once

#include <string>
#include <vector>

namespace retiarius {

struct ChartAxis {
  bool log = false;
  double low = 0.0, high = 1.0;  // low < high; positive where logarithmic
  std::vector<double> ticks;
  std::vector<std::string> labels;  // of the ticks; empty: a tick without one
  std::vector<double> minor;
  int exponent = 0;  // labels are in units of 10^exponent; 0 where logarithmic

  // 0 at the low end, 1 at the high end; NaN for what the axis cannot show.
  double fraction(double value) const;
};

// Least and greatest of the values that an axis can show: finite, and positive where logarithmic.
struct Extent {
  double low, high;  // low > high: there is none
  static Extent none();
  void add(const std::vector<double>& values, bool log);
  bool empty() const { return low > high; }
};

// Ticks at multiples of 1, 2 or 5 times a power of ten. `loose` moves the ends to ticks. An empty
// extent gives 0 to 1.
ChartAxis linear_axis(const Extent& extent, int count, bool loose);

// Labels at decades, at every few of them where there are many, and at 2 and 5 between them where
// there are few; ends at multiples 1 to 9 of a decade. An empty extent gives 1 to 10.
ChartAxis log_axis(const Extent& extent);

}  // namespace retiarius

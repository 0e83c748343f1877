#include "retiarius/report/chart_axis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/report/ticks.hpp"

namespace retiarius {

namespace {

// Minor ticks: fifths of a step of 1 or 5, quarters of a step of 2.
std::vector<double> between(const ChartAxis& axis) {
  std::vector<double> minor;
  if (axis.ticks.size() < 2) return minor;
  const double step = axis.ticks[1] - axis.ticks[0];
  const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
  const int parts = mantissa > 1.5 && mantissa < 3.0 ? 4 : 5;
  const double fine = step / parts;
  const auto first = static_cast<long long>(std::ceil(axis.low / fine - 1e-9));
  const auto last = static_cast<long long>(std::floor(axis.high / fine + 1e-9));
  for (long long k = first; k <= last; ++k)
    if (k % parts != 0) minor.push_back(static_cast<double>(k) * fine);
  return minor;
}

double at_decade(int decade, int digit) { return digit * std::pow(10.0, decade); }

std::string log_label(int decade, int digit, bool plain) {
  if (plain) return fmt::format("{:g}", at_decade(decade, digit));
  std::string power = decade == 0 ? "1" : decade == 1 ? "10" : power_of_ten(decade);
  if (digit == 1) return power;
  return decade == 0 ? fmt::format("{}", digit) : fmt::format("{}\u00b7{}", digit, power);
}

}  // namespace

double ChartAxis::fraction(double value) const {
  if (!std::isfinite(value) || (log && value <= 0.0)) return NAN;
  if (log) return std::log(value / low) / std::log(high / low);
  return (value - low) / (high - low);
}

Extent Extent::none() { return {INFINITY, -INFINITY}; }

void Extent::add(const std::vector<double>& values, bool log) {
  for (double v : values) {
    if (!std::isfinite(v) || (log && v <= 0.0)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
}

ChartAxis linear_axis(const Extent& extent, int count, bool loose) {
  const Axis nice = extent.empty() ? nice_axis(0.0, 1.0, count, loose)
                                   : nice_axis(extent.low, extent.high, count, loose);
  ChartAxis axis;
  axis.low = nice.low;
  axis.high = nice.high;
  axis.ticks = nice.ticks;
  axis.labels = nice.labels;
  axis.exponent = nice.exponent;
  axis.minor = between(axis);
  return axis;
}

ChartAxis log_axis(const Extent& extent) {
  ChartAxis axis;
  axis.log = true;
  const double low = extent.empty() ? 1.0 : extent.low, high = extent.empty() ? 10.0 : extent.high;
  int first = static_cast<int>(std::floor(std::log10(low) + 1e-12));
  int last = static_cast<int>(std::floor(std::log10(high) + 1e-12));
  const auto digit_of = [](double value, int decade) { return value / std::pow(10.0, decade); };
  int low_digit = std::max(1, static_cast<int>(std::floor(digit_of(low, first) + 1e-9)));
  int high_digit = std::max(1, static_cast<int>(std::ceil(digit_of(high, last) - 1e-9)));
  if (first == last && high_digit - low_digit < 1) {  // too short to be read: widened
    low_digit = std::max(1, low_digit - 1);
    high_digit += 1;
  }
  axis.low = at_decade(first, low_digit);
  axis.high = at_decade(last, high_digit);
  if (high_digit == 10) ++last;
  const double decades = std::log10(axis.high / axis.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 7.0)));
  const bool plain = axis.low >= 0.009 && axis.high <= 1000.5;
  for (int d = first; d <= last; ++d)
    for (int digit = 1; digit <= 9; ++digit) {
      const double tick = at_decade(d, digit);
      if (tick < axis.low * (1 - 1e-9) || tick > axis.high * (1 + 1e-9)) continue;
      const bool shown = digit == 1
                             ? d % every == 0
                             : decades < 0.7 || (decades < 2.2 && (digit == 2 || digit == 5));
      if (!shown) {
        if (digit == 1 || decades < 12.0) axis.minor.push_back(tick);
        continue;
      }
      axis.ticks.push_back(tick);
      axis.labels.push_back(log_label(d, digit, plain));
    }
  return axis;
}

}  // namespace retiarius

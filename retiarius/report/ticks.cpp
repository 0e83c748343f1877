#include "retiarius/report/ticks.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace retiarius {

namespace {

// The nearest of 1, 2 or 5 times a power of ten.
double nice_step(double raw) {
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double fraction = raw / power;
  if (fraction < 1.5) return power;
  if (fraction < 3.5) return 2.0 * power;
  if (fraction < 7.5) return 5.0 * power;
  return 10.0 * power;
}

// Numbers between 0.01 and 10000 are written as they are, others in a power of a thousand.
int label_exponent(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  if (size == 0.0 || (size >= 0.01 && size < 1e4)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(size) / 3.0));
}

}  // namespace

Axis nice_axis(double low, double high, int count, bool loose) {
  if (!(high > low)) {
    const double widening = low == 0.0 ? 1.0 : 0.5 * std::abs(low);
    low -= widening;
    high += widening;
  }
  // A range far below the size of its numbers is their rounding, not something to enlarge.
  const double smallest = 1e-12 * std::max(std::abs(low), std::abs(high));
  if (high - low < smallest) {
    low -= smallest;
    high += smallest;
  }
  const double step = nice_step((high - low) / count);
  Axis axis;
  axis.low = loose ? step * std::floor(low / step + 1e-9) : low;
  axis.high = loose ? step * std::ceil(high / step - 1e-9) : high;
  axis.exponent = label_exponent(axis.low, axis.high);
  const double unit = std::pow(10.0, axis.exponent);
  const int decimals =
      std::clamp(static_cast<int>(std::ceil(-std::log10(step / unit) - 1e-9)), 0, 12);
  const auto first = static_cast<long long>(std::ceil(axis.low / step - 1e-9));
  const auto last = static_cast<long long>(std::floor(axis.high / step + 1e-9));
  for (long long k = first; k <= last; ++k) {
    const double tick = static_cast<double>(k) * step;
    axis.ticks.push_back(tick);
    std::string label = fmt::format("{:.{}f}", tick / unit, decimals);
    if (label[0] == '-') label.replace(0, 1, "\u2212");
    axis.labels.push_back(label);
  }
  return axis;
}

std::string power_of_ten(int exponent) {
  if (exponent == 0) return "";
  const char* digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                          "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = "10";
  for (char c : std::to_string(exponent)) text += c == '-' ? "\u207b" : digits[c - '0'];
  return text;
}

}  // namespace retiarius

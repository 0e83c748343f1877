#include "retiarius/campaign/statistics.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/vec.hpp"

namespace retiarius {

double normal_quantile(double p) {
  if (!(p > 0.0 && p < 1.0))
    throw Error(fmt::format("a quantile needs a probability between 0 and 1, not {}", p));
  // Newton's method on the logarithm, in the tail where the distribution function keeps its digits:
  // it is concave there, so from the left of the root the iteration climbs to it.
  const bool upper = p > 0.5;
  const double tail = upper ? 1.0 - p : p;
  double z = -std::sqrt(-2.0 * std::log(tail));
  for (int k = 0; k < 100; ++k) {
    const double below = 0.5 * std::erfc(-z / std::sqrt(2.0));
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * kPi);
    const double step = below / density * std::log(tail / below);
    z += step;
    if (std::abs(step) <= 1e-15 * std::max(1.0, std::abs(z))) break;
  }
  return upper ? -z : z;
}

Interval wilson_interval(std::int64_t successes, std::int64_t trials, double confidence) {
  if (successes < 0 || trials < successes)
    throw Error(fmt::format("{} successes of {} trials", successes, trials));
  if (!(confidence > 0.0 && confidence < 1.0))
    throw Error(fmt::format("a confidence lies between 0 and 1, not at {}", confidence));
  if (trials == 0) return {0.0, 1.0};
  const double n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  const double z = normal_quantile(0.5 * (1.0 + confidence));
  const double middle = (share + 0.5 * z * z / n) / (1.0 + z * z / n);
  const double half =
      z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + 0.25 * z * z / (n * n));
  // At the ends the exact values, which rounding would miss.
  return {successes == 0 ? 0.0 : std::max(0.0, middle - half),
          successes == trials ? 1.0 : std::min(1.0, middle + half)};
}

}  // namespace retiarius

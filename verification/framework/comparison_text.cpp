#include "verification/framework/comparison_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/report/ticks.hpp"

namespace retiarius::verification {

namespace {

constexpr double kRoundOff = 1e-11;  // errors below it are no news
// Shares of the bound below which an error may be what round-off left of an iteration.
constexpr double kNegligible = 0.01;
constexpr double kExactBound = 1e-9;  // a bound that only allows for round-off
constexpr const char* kMinus = "\u2212";

std::string with_minus(std::string text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, kMinus);
  return text;
}

int magnitude(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

double allowed(const Comparison& c) {
  return c.kind == ErrorKind::relative ? c.bound * std::abs(c.reference) : c.bound;
}

// Significant digits of numbers as large as those compared that reach the place of the bound.
int digits_of(const Comparison& c) {
  const double size = std::max(std::abs(c.ours), std::abs(c.reference));
  if (!(allowed(c) > 0.0) || !std::isfinite(size) || size == 0.0) return 10;
  return std::clamp(magnitude(size) - magnitude(allowed(c)) + 1, 3, 10);
}

std::string value_text(const Comparison& c, double value) {
  if (std::abs(value) < 0.1 * allowed(c) && std::abs(c.reference) < 0.1 * allowed(c)) return "0";
  return printed(value, digits_of(c));
}

std::string kind_text(const Comparison& c) {
  if (c.kind == ErrorKind::relative) return " rel.";
  return c.unit == "1" ? " abs." : unit_text(c.unit);
}

std::string without_end_zeros(std::string text) {
  const std::size_t times = text.find("\u00b7");
  const std::string tail = times == std::string::npos ? "" : text.substr(times);
  text.resize(std::min(times, text.size()));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text + tail;
}

}  // namespace

std::string printed(double value, int digits) {
  if (value == 0.0) return "0";
  if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : "infinite";
  // Rounding may carry into the next decade: 9.97 to two digits is 10.
  const double rounded = std::stod(fmt::format("{:.{}e}", value, digits - 1));
  const int size = magnitude(rounded);
  if (size >= -3 && size < 6)
    return with_minus(fmt::format("{:.{}f}", rounded, std::max(0, digits - 1 - size)));
  return with_minus(fmt::format("{:.{}f}\u00b7{}", rounded / std::pow(10.0, size), digits - 1,
                                power_of_ten(size)));
}

std::string unit_text(const std::string& unit) {
  return unit.empty() || unit == "1" ? "" : " " + unit;
}

std::string ours_text(const Comparison& c) { return value_text(c, c.ours); }

std::string reference_text(const Comparison& c) {
  return without_end_zeros(value_text(c, c.reference));
}

std::string error_text(const Comparison& c) {
  const double error = c.error();
  if (c.passes() && c.bound <= kExactBound) return "< " + bound_text(c);
  const double scale = c.kind == ErrorKind::relative ? 1.0 : std::max(1.0, std::abs(c.reference));
  const double limit = std::max(kRoundOff * scale, kNegligible * c.bound);
  if (error < limit) return "< " + without_end_zeros(printed(limit, 2)) + kind_text(c);
  const int digits = error < 0.1 * c.bound ? 1 : 2;
  return without_end_zeros(printed(error, digits)) + kind_text(c);
}

std::string bound_text(const Comparison& c) {
  return without_end_zeros(printed(c.bound, 2)) + kind_text(c);
}

std::string verdict_word(const CaseResult& result) {
  if (!result.failure.empty()) return "FAILED";
  if (!result.passes()) return "MISS";
  return result.comparisons.empty() ? "drawn" : "ok";
}

Tally tally(const std::vector<Rung>& rungs) {
  Tally t;
  t.cases = rungs.size();
  for (const Rung& rung : rungs) {
    t.passed += rung.result.passes() ? 1 : 0;
    t.comparisons += rung.result.comparisons.size();
    t.within += static_cast<std::size_t>(
        std::count_if(rung.result.comparisons.begin(), rung.result.comparisons.end(),
                      [](const Comparison& c) { return c.passes(); }));
  }
  return t;
}

}  // namespace retiarius::verification

#include "retiarius/study/judgement.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {

namespace {

constexpr double kRoundOff = 1e-11;  // relative changes below it have no order

bool here(double value) { return std::isfinite(value); }

// Order and limit from the last three values.
void add_order(const std::vector<double>& v, double scale, Judgement& judgement) {
  const std::size_t n = v.size();
  if (n < 3 || !here(v[n - 3])) return;
  const double before = v[n - 2] - v[n - 3], last = v[n - 1] - v[n - 2];
  if (before * last <= 0.0 || std::abs(last) >= std::abs(before)) return;
  if (std::abs(last) <= kRoundOff * scale) return;
  judgement.order = std::log2(before / last);
  judgement.limit = v[n - 1] + last / (before / last - 1.0);
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::does_not_hold:
      return "does not hold";
    case Verdict::chaotic:
      return "chaotic";
    case Verdict::unknown:
      return "unknown";
  }
  return "";
}

Judgement judge(std::vector<double> values, double size, double tolerance) {
  Judgement judgement;
  const auto present = std::count_if(values.begin(), values.end(), here);
  if (present < 2) return judgement;
  const std::size_t n = values.size();
  const double last = values[n - 1], before = values[n - 2];
  if (!here(last) || !here(before)) {
    judgement.verdict = Verdict::does_not_hold;
    return judgement;
  }
  const double scale = std::max({std::abs(last), std::abs(before), size});
  const double change = std::abs(last - before);
  judgement.change = scale > 0.0 ? change / scale : 0.0;
  add_order(values, scale, judgement);
  const bool shrinks = n < 3 || !here(values[n - 3]) || change < std::abs(before - values[n - 3]);
  judgement.verdict = *judgement.change <= tolerance ? Verdict::holds
                      : shrinks                      ? Verdict::does_not_hold
                                                     : Verdict::chaotic;
  return judgement;
}

}  // namespace retiarius

#include "verification/framework/results.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius::verification {

double Comparison::error() const {
  const double off = std::abs(ours - reference);
  return kind == ErrorKind::relative ? off / std::abs(reference) : off;
}

bool Comparison::passes() const { return std::isfinite(error()) && error() <= bound; }

bool CaseResult::passes() const {
  return failure.empty() && !(comparisons.empty() && charts.empty()) &&
         std::all_of(comparisons.begin(), comparisons.end(),
                     [](const Comparison& c) { return c.passes(); });
}

}  // namespace retiarius::verification

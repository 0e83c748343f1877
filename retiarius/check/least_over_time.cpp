#include "retiarius/check/least_over_time.hpp"

#include <vector>

namespace retiarius::check {

Least least_over_time(const std::function<double(double)>& f, double rate, double enough,
                      double resolution) {
  constexpr int kMostValues = 100000;
  struct Span {
    double middle, half;
  };
  Least least{enough, 0.0, true};
  std::vector<Span> open{{0.5, 0.5}};
  for (int k = 0; !open.empty(); ++k) {
    if (k == kMostValues) {
      least.resolved = false;
      return least;
    }
    const Span span = open.back();
    open.pop_back();
    const double value = f(span.middle);
    if (value < least.value) {
      least.value = value;
      least.time = span.middle;
    }
    const double swing = rate * span.half;
    if (value - swing >= least.value || swing <= resolution) continue;
    const double quarter = 0.5 * span.half;
    open.push_back({span.middle + quarter, quarter});
    open.push_back({span.middle - quarter, quarter});
  }
  return least;
}

}  // namespace retiarius::check

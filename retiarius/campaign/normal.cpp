#include "retiarius/campaign/normal.hpp"

#include <cmath>

namespace retiarius {

double normal_share(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

// Abramowitz & Stegun (1964) 26.2.23 gives three digits; each step of Halley's method on
// normal_share() triples their number. The upper half mirrors the lower one, whose shares keep
// their digits.
double normal_quantile(double share) {
  if (share > 0.5) return -normal_quantile(1.0 - share);
  const double t = std::sqrt(-2.0 * std::log(share));
  double x = (2.515517 + t * (0.802853 + t * 0.010328)) /
                 (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308))) -
             t;
  for (int i = 0; i < 3; ++i) {
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * 3.14159265358979323846);
    const double step = (normal_share(x) - share) / density;
    x -= step / (1.0 + 0.5 * x * step);
  }
  return x;
}

}  // namespace retiarius

#include "verification/framework/swing.hpp"

#include <cstddef>

namespace retiarius::verification {

double squared_frequency(const std::vector<double>& samples, double h) {
  // From second differences, which keep their digits where a step turns by little.
  double top = 0.0, bottom = 0.0;
  for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
    const double bend = samples[k + 1] - 2.0 * samples[k] + samples[k - 1];
    top += bend * samples[k];
    bottom += samples[k] * samples[k];
  }
  const double half = -0.25 * top / bottom;  // q / (1 + q)
  return 4.0 / (h * h) * half / (1.0 - half);
}

}  // namespace retiarius::verification

#include "verification/framework/oscillation.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/base/error.hpp"

namespace retiarius::verification {

std::complex<double> measured_factor(const std::vector<double>& samples, int stride) {
  const std::size_t m = static_cast<std::size_t>(stride);
  double pp = 0.0, pq = 0.0, qq = 0.0, rp = 0.0, rq = 0.0;
  for (std::size_t n = m; n + m < samples.size(); ++n) {
    const double p = samples[n], q = samples[n - m], r = samples[n + m];
    pp += p * p, pq += p * q, qq += q * q, rp += r * p, rq += r * q;
  }
  const double det = pp * qq - pq * pq;
  if (!(det > 0.0)) throw Error("an oscillation was to be measured, but there is none");
  const double a = (rp * qq - rq * pq) / det;
  const double b = (rq * pp - rp * pq) / det;
  const std::complex<double> power =
      0.5 * a + std::sqrt(std::complex<double>(b + 0.25 * a * a, 0.0));
  return std::exp(std::log(power) / static_cast<double>(stride));
}

std::complex<double> exponent_of(std::complex<double> factor, Method method, double h) {
  if (method == Method::implicit_euler) return (1.0 - 1.0 / factor) / h;
  return (2.0 / h) * (factor - 1.0) / (factor + 1.0);
}

std::complex<double> measured_exponent(const std::vector<double>& samples, Method method, double h,
                                       double period) {
  const int quarter = static_cast<int>(std::lround(0.25 * period / h));
  return exponent_of(measured_factor(samples, std::max(1, quarter)), method, h);
}

}  // namespace retiarius::verification

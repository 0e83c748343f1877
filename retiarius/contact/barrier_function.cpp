#include "retiarius/contact/barrier_function.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/base/vec.hpp"

namespace retiarius {

Jet barrier(double gap, double range) {
  if (gap >= range) return {};
  if (!(gap > 0.0)) return {kInfinity, -kInfinity, kInfinity};
  const double off = gap - range;
  const double log = std::log(gap / range);
  const double ratio = off / gap;
  return {-off * off * log, -2.0 * off * log - off * ratio,
          -2.0 * log - 4.0 * ratio + ratio * ratio};
}

SlipJet smooth_slip(double slip, double smallest) {
  if (slip >= smallest) return {slip - smallest / 3.0, 1.0, 0.0, 1.0 / slip};
  const double u = slip / smallest;
  return {smallest * (u * u - u * u * u / 3.0), u * (2.0 - u), 2.0 * (1.0 - u) / smallest,
          (2.0 - u) / smallest};
}

double share_of_newton(const Vec3& before, const Vec3& slip) {
  const double sizes = before.norm() * slip.norm();
  return sizes > 0.0 ? std::max(0.0, before.dot(slip) / sizes) : 1.0;
}

}  // namespace retiarius

#include "retiarius/bodies/free_rotation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

Quat rotation(const Vec3& vector) {
  const double angle = vector.norm();
  const double half = 0.5 * angle;
  // sin(angle/2) / angle; the series is exact to round-off below the threshold.
  const double factor = angle < 1e-4 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  return Quat(std::cos(half), factor * vector.x(), factor * vector.y(), factor * vector.z());
}

Quat turn_freely(const Mat3& inverse_inertia, const Quat& attitude, const Vec3& angular_momentum,
                 double h, int substeps) {
  const double s = h / substeps;
  const auto turn = [&](const Quat& q) -> Vec3 {
    const Vec3 body = q.conjugate() * angular_momentum;
    return s * (q * (inverse_inertia * body));
  };
  Quat q = attitude;
  for (int k = 0; k < substeps; ++k) {
    const Vec3 k1 = turn(q);
    const Quat half = rotation(0.5 * k1) * q;
    const Vec3 k2 = turn(half);
    const Vec3 k3 = turn(rotation(0.5 * k2) * q);
    const Vec3 k4 = turn(rotation(k3 - 0.5 * k1) * half);
    const Vec3 first = (3.0 * k1 + 2.0 * k2 + 2.0 * k3 - k4) / 12.0;
    const Vec3 second = (-k1 + 2.0 * k2 + 2.0 * k3 + 3.0 * k4) / 12.0;
    q = (rotation(second) * (rotation(first) * q)).normalized();
  }
  return q;
}

int free_rotation_substeps(double angle) {
  constexpr double kLargest = 1000.0;
  if (!(angle <= kLargest)) {
    throw RunError(fmt::format(
        "a body turns by {:.3g} rad in one step; at most {} rad can be followed: reduce the step "
        "or its spin",
        angle, kLargest));
  }
  // n substeps leave an error of at most 0.05 angle^5 / n^4, found for inertias of any ratio.
  constexpr double kAllowed = 1e-10;
  const double needed = std::pow(0.05 * std::pow(angle, 5) / kAllowed, 0.25);
  return std::max(1, static_cast<int>(std::ceil(needed)));
}

}  // namespace retiarius

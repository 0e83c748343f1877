#include "retiarius/bodies/convex_search.hpp"

#include <algorithm>

namespace retiarius {
namespace {

// Value and slope of the distance along the segment, t in [0, 1].
struct Sample {
  double t;
  double value;
  double slope;
};

}  // namespace

double convex_segment_distance(const Shape& shape, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const auto sample = [&](double t) -> Sample {
    const SurfacePoint s = shape.nearest(a + t * along);
    return {t, s.distance, s.normal.dot(along)};
  };
  Sample left = sample(0.0);
  if (left.slope >= 0.0) return left.value;
  Sample right = sample(1.0);
  if (right.slope <= 0.0) return right.value;

  const double tolerance = 1e-13 * (a.norm() + along.norm());
  double best = std::min(left.value, right.value);
  constexpr int kMost = 200;  // bisection alone needs 60
  for (int iteration = 0; iteration < kMost; ++iteration) {
    // Where the tangents meet, and the lower bound of the minimum there.
    const double width = right.t - left.t;
    const double rise = right.value - left.value - left.slope * width;
    const double step =
        std::clamp((right.slope * width - (right.value - left.value)) / (right.slope - left.slope),
                   0.0, width);
    const double bound =
        std::max(left.value + left.slope * step, right.value - right.slope * (width - step));
    if (best - bound <= tolerance || rise <= 0.0 || width < 1e-16) break;
    const bool bisect = iteration % 3 == 2;
    const Sample middle = sample(left.t + (bisect ? 0.5 * width : step));
    best = std::min(best, middle.value);
    if (middle.slope == 0.0) break;
    (middle.slope < 0.0 ? left : right) = middle;
  }
  return best;
}

}  // namespace retiarius

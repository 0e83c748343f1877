// Distance from a straight segment to a convex shape.
#pragma once

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// Smallest signed distance from the segment a-b to a convex shape. The signed distance to a convex
// set is a convex function, also inside, and the normal is its subgradient; so the tangents at two
// points on either side of the minimum bound it from below (Kelley's cutting planes, safeguarded
// by bisection). The result is within 1e-13 of the size |a| + |b - a| of the true minimum.
double convex_segment_distance(const Shape& shape, const Vec3& a, const Vec3& b);

}  // namespace retiarius

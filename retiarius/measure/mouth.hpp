// The mouth: the closed polygon of the net's corners, and what is measured on it.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// The places of the chosen nodes, in order.
std::vector<Vec3> polygon(const std::vector<Vec3>& x, const std::vector<Index>& nodes);

// 1/2 sum x_i x x_(i+1) over a closed polygon (m2): its length is the largest area that any
// projection of the polygon shows, taking signs into account; it does not depend on the origin.
// Zero with fewer than three corners.
Vec3 area_vector(const std::vector<Vec3>& corners);

// Area of the polygon projected on the plane with the given unit normal: the absolute value of the
// signed area, m2. Parts that run the other way round count negative.
double projected_area(const std::vector<Vec3>& corners, const Vec3& normal);

// The largest distance between two corners, m; zero with fewer than two.
double width(const std::vector<Vec3>& corners);

}  // namespace retiarius

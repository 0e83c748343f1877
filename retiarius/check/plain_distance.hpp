// Plain distances between points, segments and triangles, written for checking alone.
#pragma once

#include <array>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius::check {

// Shares no code with contact detection, which it is there to check. All in m.
double point_segment(const Vec3& p, const Vec3& a, const Vec3& b);
double segment_segment(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

using Triangle = std::array<Vec3, 3>;
double point_triangle(const Vec3& p, const Triangle& t);

// 0 where the segment pierces the triangle.
double segment_triangle(const Vec3& a, const Vec3& b, const Triangle& t);

// How often closed triangles surround a point: 1 inside, 0 outside, by the sum of solid angles
// (van Oosterom & Strackee 1983).
double winding_number(const Vec3& p, const std::vector<Triangle>& surface);

}  // namespace retiarius::check

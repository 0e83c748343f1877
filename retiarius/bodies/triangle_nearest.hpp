// Distances from points and straight segments to one triangle.
#pragma once

#include <array>

#include "retiarius/base/vec.hpp"

namespace retiarius {

using Corners = std::array<Vec3, 3>;

// What of a triangle is nearest: its face, an edge (edge k runs from corner k to k + 1), a corner.
enum class Feature { face, edge0, edge1, edge2, corner0, corner1, corner2 };

struct TrianglePoint {
  Vec3 point = Vec3::Zero();
  Feature feature = Feature::face;
};

// The point of the triangle nearest to p, by the Voronoi regions of its features (Ericson,
// Real-Time Collision Detection, 2005, section 5.1.5).
TrianglePoint nearest_on_triangle(const Vec3& p, const Corners& triangle);

// Distance between the segments a-b and c-d, m (Ericson, section 5.1.9).
double segment_segment_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// Distance between the segment a-b and the triangle, m; zero to round-off where they cross.
double segment_triangle_distance(const Vec3& a, const Vec3& b, const Corners& triangle);

}  // namespace retiarius

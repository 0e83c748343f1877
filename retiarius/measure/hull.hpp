// The convex hull of a net's nodes, and how much of a body it holds.
#pragma once

#include <optional>
#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/bodies/shape.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// A convex polyhedron with volume, as its bounding planes.
struct ConvexHull {
  struct Plane {
    Vec3 normal = Vec3::UnitZ();  // unit, outward
    double offset = 0.0;          // m; inside is normal.x + offset <= 0
  };
  std::vector<Plane> planes;
  double volume = 0.0;     // m3
  double area = 0.0;       // m2
  double tolerance = 0.0;  // m; a point this far outside of a plane still counts as inside

  bool contains(const Vec3& point) const;
};

// Convex hull of points, m, by Quickhull (Barber, Dobkin & Huhdanpaa 1996; qhull). Empty if there
// are fewer than four points or all lie in a plane within rounding: such a hull holds nothing.
// Throws RunError for points that are not finite or if qhull fails.
std::optional<ConvexHull> convex_hull(const std::vector<Vec3>& points);

// Share of the area of a surface (body axes; `pose` puts it into the world) that lies inside the
// hull, 0 to 1: each triangle is clipped by the hull's planes, so it is exact but for rounding.
// The surface must have an area.
double captured_share(const TriangleMesh& surface, const BodyState& pose, const ConvexHull& hull);

}  // namespace retiarius

// Triangle surfaces of solids of revolution about z.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// A meridian runs from the axis at the bottom to the axis at the top: points (distance from the
// axis, z), m; only the first and the last lie on the axis.
using Meridian = std::vector<Eigen::Vector2d>;

// Closed surface, turned about z in 72 sectors: the chord misses the circle by 1e-3 radius.
TriangleMesh revolved_triangles(const Meridian& meridian);

// Meridian of a capsule (a sphere for length 0) with 36 chords on its two caps together.
Meridian capsule_meridian(double radius, double length);

}  // namespace retiarius

// Prisms and pyramids around cylinders and cones.
#pragma once

#include "retiarius/bodies/body.hpp"

namespace retiarius {

// The radius of a surface of revolution about z: its largest distance from the axis.
double revolved_radius(const TriangleMesh& surface);

// A closed surface around a body of kind cylinder or cone whose flat sides touch it along a line
// each: it misses the body by at most `chord_error` (m, across the axis) and holds all of it. At
// least 12 and at most 2048 sides; the ends are fans of triangles in one plane.
TriangleMesh around_revolved(const Body& body, double chord_error);

}  // namespace retiarius

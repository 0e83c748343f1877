// The triangles by which files and pictures show a body.
#pragma once

#include "retiarius/bodies/body.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {

// Triangles in body axes. A plane, which has no end, is shown as a square across body z through
// the body's origin, twice as wide as the net as designed.
TriangleMesh drawn_mesh(const Body& body, const Network& network);

// Radius of a ball of steel of this mass (kg), m: how a corner mass is shown.
double steel_ball_radius(double mass);

// A name made safe for use in a file name: bytes other than letters, digits, '-', '_', '.' become
// '_'.
std::string file_name_of(const std::string& name);

}  // namespace retiarius

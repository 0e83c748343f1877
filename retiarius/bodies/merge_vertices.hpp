// Makes one vertex of those that files repeat.
#pragma once

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// Diagonal of the box about the vertices, m; the scale of tolerances.
double mesh_size(const TriangleMesh& mesh);

// Vertices within `tolerance` (m, positive) of an earlier one become that one, and vertices that
// no triangle uses go; the order of the others stays.
TriangleMesh merge_vertices(const TriangleMesh& mesh, double tolerance);

}  // namespace retiarius

// Mass properties of the solid inside a closed triangle surface.
#pragma once

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// Volume (negative for a surface turned inside out), mass centre, and inertia about it, by the
// divergence theorem: the sum over the tetrahedra from one point to each triangle, whose moments
// are closed (Mirtich 1996; Tonon 2004). Exact but for rounding.
SolidProperties mesh_solid(const TriangleMesh& mesh);

// Area of all triangles, m2.
double mesh_area(const TriangleMesh& mesh);

}  // namespace retiarius

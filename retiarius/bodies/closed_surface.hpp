// Makes of loose triangles the closed, outward oriented surface of a solid, or says why not.
#pragma once

#include <string>

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// Merges vertices nearer than 1e-9 of the mesh's size, checks that the surface is a closed
// 2-manifold and orients it: triangles that face the wrong way are turned. Several closed parts are
// allowed. They must not cross each other (this is not checked); a part inside another must be
// oriented inward, as the wall of a cavity. `file` is named in errors.
// Throws InputError for: triangles without area, an open edge, an edge of more than two triangles,
// a vertex at which the surface touches itself, a surface that cannot be oriented, a part inside
// another that faces outward, no volume.
TriangleMesh closed_surface(const TriangleMesh& loose, const std::string& file);

}  // namespace retiarius

// A body whose surface is a closed triangle mesh.
#pragma once

#include <memory>

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// `surface` is closed and oriented outward (see closed_surface), with the solid's mass centre at
// the origin. Inside and outside are told by the angle-weighted pseudonormal of the nearest face,
// edge or vertex (Baerentzen & Aanaes, IEEE Trans. Vis. Comput. Graph. 11, 2005).
std::shared_ptr<const Shape> make_mesh(TriangleMesh surface);

}  // namespace retiarius

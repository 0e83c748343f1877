// What becomes of the triangles of a mesh file: a closed surface, its mass properties and its
// distance, as build_shape makes them.
#pragma once

#include <cmath>
#include <utility>

#include "fuzz/target.hpp"
#include "retiarius/bodies/closed_surface.hpp"
#include "retiarius/bodies/mesh_file.hpp"
#include "retiarius/bodies/mesh_shape.hpp"
#include "retiarius/bodies/mesh_solid.hpp"

namespace retiarius::fuzz {

inline void make_solid(const TriangleMesh& loose) {
  if (loose.triangles.empty()) return;  // read_mesh() refuses it
  TriangleMesh surface = closed_surface(loose, "m.stl");
  const SolidProperties solid = mesh_solid(surface);
  require(std::isfinite(solid.volume) && solid.volume > 0.0, "a solid without volume");
  require(solid.center.allFinite() && solid.inertia.allFinite(), "a solid that is not finite");
  for (Vec3& p : surface.vertices) p -= solid.center;
  const auto shape = make_mesh(std::move(surface));
  const SurfacePoint nearest = shape->nearest(Vec3(0.1, 0.2, 0.3));
  require(std::isfinite(nearest.distance), "a distance that is not finite");
}

}  // namespace retiarius::fuzz

#include "retiarius/bodies/shape.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/closed_surface.hpp"
#include "retiarius/bodies/mesh_file.hpp"
#include "retiarius/bodies/mesh_shape.hpp"
#include "retiarius/bodies/mesh_solid.hpp"
#include "retiarius/bodies/primitives.hpp"

namespace retiarius {
namespace {

std::string name_of(const BodySpec& spec) { return spec.name.empty() ? "target" : spec.name; }

double checked_length(const BodySpec& spec, const char* key, double value) {
  if (std::isfinite(value) && value > 0.0) return value;
  throw InputError(
      fmt::format("{}: {} is {} m; it must be positive and finite", name_of(spec), key, value));
}

std::shared_ptr<const Shape> build_box(const BodySpec& spec) {
  checked_length(spec, "size[0]", spec.size.x());
  checked_length(spec, "size[1]", spec.size.y());
  checked_length(spec, "size[2]", spec.size.z());
  return make_box(spec.size);
}

ShapeInBody build_mesh(const BodySpec& spec, const std::string& folder) {
  if (spec.file.empty()) {
    throw InputError(fmt::format("{}: a mesh needs file, an STL or OBJ file", name_of(spec)));
  }
  if (!(std::isfinite(spec.scale) && spec.scale > 0.0)) {
    throw InputError(
        fmt::format("{}: scale is {}; it must be positive and finite", name_of(spec), spec.scale));
  }
  // An absolute file replaces the folder.
  const std::string path = (std::filesystem::path(folder) / spec.file).string();
  TriangleMesh mesh = read_mesh(path);
  for (Vec3& p : mesh.vertices) p *= spec.scale;
  mesh = closed_surface(mesh, path);
  const Vec3 center = mesh_solid(mesh).center;
  for (Vec3& p : mesh.vertices) p -= center;
  return {make_mesh(std::move(mesh)), -center};
}

}  // namespace

ShapeInBody build_shape(const BodySpec& spec, const std::string& folder) {
  const auto radius = [&] { return checked_length(spec, "radius", spec.radius); };
  const auto length = [&] { return checked_length(spec, "length", spec.length); };
  switch (spec.shape) {
    case ShapeKind::sphere:
      return {make_sphere(radius())};
    case ShapeKind::box:
      return {build_box(spec)};
    case ShapeKind::cylinder:
      return {make_cylinder(radius(), length())};
    case ShapeKind::capsule:
      return {make_capsule(radius(), length())};
    case ShapeKind::cone:
      return {make_cone(radius(), length())};
    case ShapeKind::plane:
      return {make_plane()};
    case ShapeKind::mesh:
      return build_mesh(spec, folder);
  }
  throw InputError(fmt::format("{}: unknown shape", name_of(spec)));
}

}  // namespace retiarius

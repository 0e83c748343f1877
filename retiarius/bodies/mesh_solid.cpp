#include "retiarius/bodies/mesh_solid.hpp"

namespace retiarius {
namespace {

// Volume, first and second moments about `origin`.
struct Moments {
  double volume = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

Moments moments_about(const TriangleMesh& mesh, const Vec3& origin) {
  Moments sum;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[static_cast<std::size_t>(t[0])] - origin;
    const Vec3 b = mesh.vertices[static_cast<std::size_t>(t[1])] - origin;
    const Vec3 c = mesh.vertices[static_cast<std::size_t>(t[2])] - origin;
    const Vec3 all = a + b + c;
    const double volume = a.dot(b.cross(c)) / 6.0;
    sum.volume += volume;
    sum.first += volume / 4.0 * all;
    sum.second +=
        volume / 20.0 *
        (a * a.transpose() + b * b.transpose() + c * c.transpose() + all * all.transpose());
  }
  return sum;
}

}  // namespace

SolidProperties mesh_solid(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  const Vec3 start = mesh.vertices[static_cast<std::size_t>(mesh.triangles[0][0])];
  const Moments rough = moments_about(mesh, start);
  if (rough.volume == 0.0) return {};
  // Again about the mass centre, where the moments lose nothing to cancellation.
  const Vec3 center = start + rough.first / rough.volume;
  const Moments fine = moments_about(mesh, center);
  const Mat3 inertia = fine.second.trace() * Mat3::Identity() - fine.second;
  return {fine.volume, center, inertia};
}

double mesh_area(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
    area += 0.5 * (mesh.vertices[static_cast<std::size_t>(t[1])] - a)
                      .cross(mesh.vertices[static_cast<std::size_t>(t[2])] - a)
                      .norm();
  }
  return area;
}

}  // namespace retiarius

#include "retiarius/bodies/revolved_triangles.hpp"

#include <cmath>

namespace retiarius {
namespace {

constexpr int kSectors = 72;

}  // namespace

TriangleMesh revolved_triangles(const Meridian& meridian) {
  TriangleMesh mesh;
  const int rings = static_cast<int>(meridian.size()) - 2;
  mesh.vertices.emplace_back(0.0, 0.0, meridian.front().y());
  for (int ring = 0; ring < rings; ++ring) {
    const Eigen::Vector2d& point = meridian[static_cast<std::size_t>(ring) + 1];
    for (int k = 0; k < kSectors; ++k) {
      const double angle = 2.0 * kPi * k / kSectors;
      mesh.vertices.emplace_back(point.x() * std::cos(angle), point.x() * std::sin(angle),
                                 point.y());
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, meridian.back().y());

  const auto at = [](int ring, int k) -> Index { return 1 + ring * kSectors + k % kSectors; };
  const Index top = static_cast<Index>(mesh.vertices.size()) - 1;
  for (int k = 0; k < kSectors; ++k) {
    mesh.triangles.push_back({0, at(0, k + 1), at(0, k)});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
      mesh.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
    }
    mesh.triangles.push_back({at(rings - 1, k), at(rings - 1, k + 1), top});
  }
  return mesh;
}

Meridian capsule_meridian(double radius, double length) {
  constexpr int kChords = kSectors / 4;  // of each cap
  Meridian meridian;
  for (int k = 0; k <= 2 * kChords; ++k) {
    const double angle = kPi * k / (2 * kChords);  // from the bottom
    const double shift = k <= kChords ? -0.5 * length : 0.5 * length;
    meridian.emplace_back(radius * std::sin(angle), shift - radius * std::cos(angle));
    if (k == kChords && length > 0.0) meridian.emplace_back(radius, 0.5 * length);
  }
  return meridian;
}

}  // namespace retiarius

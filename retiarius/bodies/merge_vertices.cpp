#include "retiarius/bodies/merge_vertices.hpp"

#include <cmath>
#include <unordered_map>

namespace retiarius {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t k : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15ull;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

// Points kept so far, found again by cells as wide as the tolerance.
class KeptPoints {
 public:
  KeptPoints(const Vec3& corner, double tolerance) : corner_(corner), tolerance_(tolerance) {}

  Index find_or_add(const Vec3& point) {
    const Cell center = cell_of(point);
    for (int k = 0; k < 27; ++k) {
      const Cell cell = {center[0] + k % 3 - 1, center[1] + k / 3 % 3 - 1, center[2] + k / 9 - 1};
      const auto [first, last] = cells_.equal_range(cell);
      for (auto it = first; it != last; ++it) {
        const Vec3& kept = points_[static_cast<std::size_t>(it->second)];
        if ((kept - point).norm() <= tolerance_) return it->second;
      }
    }
    const auto index = static_cast<Index>(points_.size());
    points_.push_back(point);
    cells_.emplace(center, index);
    return index;
  }

  std::vector<Vec3> take() { return std::move(points_); }

 private:
  Cell cell_of(const Vec3& point) const {
    const Vec3 scaled = (point - corner_) / tolerance_;
    return {static_cast<std::int64_t>(std::floor(scaled.x())),
            static_cast<std::int64_t>(std::floor(scaled.y())),
            static_cast<std::int64_t>(std::floor(scaled.z()))};
  }

  Vec3 corner_;
  double tolerance_;
  std::vector<Vec3> points_;
  std::unordered_multimap<Cell, Index, CellHash> cells_;
};

}  // namespace

double mesh_size(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.vertices) box.extend(p);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

TriangleMesh merge_vertices(const TriangleMesh& mesh, double tolerance) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.vertices) box.extend(p);
  KeptPoints kept(box.min(), tolerance);
  std::vector<Index> place(mesh.vertices.size(), kNone);
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const auto& triangle : mesh.triangles) {
    for (const Index v : triangle) used[static_cast<std::size_t>(v)] = true;
  }
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (used[v]) place[v] = kept.find_or_add(mesh.vertices[v]);
  }
  TriangleMesh merged{kept.take(), mesh.triangles};
  for (auto& triangle : merged.triangles) {
    for (Index& v : triangle) v = place[static_cast<std::size_t>(v)];
  }
  return merged;
}

}  // namespace retiarius

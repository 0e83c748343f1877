// Finds the nearest of many triangles: a binary tree of axis-aligned boxes.
#pragma once

#include <cstdint>
#include <vector>

#include "retiarius/bodies/shape.hpp"
#include "retiarius/bodies/triangle_nearest.hpp"

namespace retiarius {

// The tree is split at the median along the longest side, so its depth grows as the logarithm of
// the number of triangles; queries allocate nothing and may run in parallel.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& mesh);

  struct Nearest {
    Index triangle = kNone;  // of the mesh
    double distance = kInfinity;
    TrianglePoint at;
  };
  Nearest nearest(const Vec3& point) const;

  // Smallest distance from the segment a-b to a triangle, m, or `limit` if none is nearer.
  double segment_distance(const Vec3& a, const Vec3& b, double limit) const;

  // Corners of a triangle of the mesh.
  const Corners& corners(Index triangle) const {
    return corners_[static_cast<std::size_t>(place_[static_cast<std::size_t>(triangle)])];
  }

 private:
  // A leaf holds `count` triangles from `first`; an inner node (count 0) has its children at the
  // next place and at `first`.
  struct Node {
    Vec3 low, high;
    Index first;
    Index count;
  };
  void build(std::vector<Index>& order, const std::vector<Vec3>& centers, Index begin, Index end);
  template <class Bound, class Visit>
  void walk(Bound bound, const double& best, Visit visit) const;

  std::vector<Node> nodes_;
  std::vector<Corners> corners_;  // in the tree's order
  std::vector<Index> triangle_;   // of the mesh, for each in the tree's order
  std::vector<Index> place_;      // the inverse
};

}  // namespace retiarius

#include "retiarius/bodies/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace retiarius {
namespace {

constexpr Index kLeaf = 4;
constexpr std::size_t kDeepest = 64;  // more than the logarithm of any number of triangles

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  std::vector<Vec3> centers;
  std::vector<Corners> corners;
  for (const auto& t : mesh.triangles) {
    corners.push_back({mesh.vertices[at(t[0])], mesh.vertices[at(t[1])], mesh.vertices[at(t[2])]});
    centers.push_back((corners.back()[0] + corners.back()[1] + corners.back()[2]) / 3.0);
  }
  triangle_.resize(corners.size());
  std::iota(triangle_.begin(), triangle_.end(), 0);
  corners_ = corners;  // in the mesh's order while building
  build(triangle_, centers, 0, static_cast<Index>(corners.size()));
  place_.resize(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners_[k] = corners[at(triangle_[k])];
    place_[at(triangle_[k])] = static_cast<Index>(k);
  }
}

void TriangleTree::build(std::vector<Index>& order, const std::vector<Vec3>& centers, Index begin,
                         Index end) {
  Eigen::AlignedBox3d box, spread;
  for (Index k = begin; k < end; ++k) {
    for (const Vec3& corner : corners_[at(order[at(k)])]) box.extend(corner);
    spread.extend(centers[at(order[at(k)])]);
  }
  const std::size_t here = nodes_.size();
  nodes_.push_back({box.min(), box.max(), begin, end - begin});
  if (end - begin <= kLeaf) return;
  Eigen::Index axis = 0;
  spread.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](Index l, Index r) {
                     return std::pair(centers[at(l)][axis], l) < std::pair(centers[at(r)][axis], r);
                   });
  build(order, centers, begin, middle);
  nodes_[here].first = static_cast<Index>(nodes_.size());
  nodes_[here].count = 0;
  build(order, centers, middle, end);
}

// Visits triangles in boxes whose bound is below `best`, which the visits lower; nearer child
// first.
template <class Bound, class Visit>
void TriangleTree::walk(Bound bound, const double& best, Visit visit) const {
  std::array<std::pair<Index, double>, kDeepest> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, bound(nodes_[0])};
  while (depth > 0) {
    const auto [index, least] = stack[--depth];
    if (least >= best) continue;
    const Node& node = nodes_[at(index)];
    if (node.count > 0) {
      for (Index k = node.first; k < node.first + node.count; ++k) visit(at(k));
      continue;
    }
    std::pair<Index, double> near{index + 1, bound(nodes_[at(index + 1)])};
    std::pair<Index, double> far{node.first, bound(nodes_[at(node.first)])};
    if (far.second < near.second) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
}

TriangleTree::Nearest TriangleTree::nearest(const Vec3& point) const {
  // Stays so for a point that is not finite.
  Nearest found{triangle_[0], kInfinity, {corners_[0][0], Feature::corner0}};
  double best = kInfinity;  // squared distance
  const auto bound = [&](const Node& node) {
    return (point - point.cwiseMax(node.low).cwiseMin(node.high)).squaredNorm();
  };
  walk(bound, best, [&](std::size_t k) {
    const TrianglePoint candidate = nearest_on_triangle(point, corners_[k]);
    const double squared = (point - candidate.point).squaredNorm();
    if (squared >= best) return;
    best = squared;
    found.triangle = triangle_[k];
    found.at = candidate;
  });
  found.distance = std::sqrt(best);
  return found;
}

double TriangleTree::segment_distance(const Vec3& a, const Vec3& b, double limit) const {
  double best = limit;
  const Vec3 low = a.cwiseMin(b), high = a.cwiseMax(b), along = b - a;
  const double squared = along.squaredNorm();
  // The larger of two bounds: from the segment's own box, and from the sphere about the node's.
  const auto bound = [&](const Node& node) {
    const Vec3 gap = (node.low - high).cwiseMax(low - node.high).cwiseMax(Vec3::Zero());
    const Vec3 center = 0.5 * (node.low + node.high);
    const double t = squared > 0.0 ? std::clamp(along.dot(center - a) / squared, 0.0, 1.0) : 0.0;
    const double to_sphere = (a + t * along - center).norm() - 0.5 * (node.high - node.low).norm();
    return std::max(gap.norm(), to_sphere);
  };
  walk(bound, best,
       [&](std::size_t k) { best = std::min(best, segment_triangle_distance(a, b, corners_[k])); });
  return best;
}

}  // namespace retiarius

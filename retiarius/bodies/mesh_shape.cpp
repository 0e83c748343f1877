#include "retiarius/bodies/mesh_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

#include "retiarius/bodies/mesh_solid.hpp"
#include "retiarius/bodies/triangle_tree.hpp"

namespace retiarius {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

// Unit normals of a triangle's face, edges and corners, indexed by Feature.
using FeatureNormals = std::array<Vec3, 7>;

std::vector<FeatureNormals> feature_normals(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, Vec3> edges;
  std::vector<Vec3> corners(mesh.vertices.size(), Vec3::Zero());
  std::vector<FeatureNormals> normals(mesh.triangles.size());
  const auto edge_of = [](Index u, Index v) { return std::pair(std::min(u, v), std::max(u, v)); };
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    const Corners p{mesh.vertices[at(t[0])], mesh.vertices[at(t[1])], mesh.vertices[at(t[2])]};
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    normals[k][0] = normal;
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3 ahead = p[(j + 1) % 3] - p[j], behind = p[(j + 2) % 3] - p[j];
      const double angle = std::atan2(ahead.cross(behind).norm(), ahead.dot(behind));
      corners[at(t[j])] += angle * normal;
      edges.try_emplace(edge_of(t[j], t[(j + 1) % 3]), Vec3::Zero()).first->second += normal;
    }
  }
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& t = mesh.triangles[k];
    for (std::size_t j = 0; j < 3; ++j) {
      normals[k][1 + j] = edges.at(edge_of(t[j], t[(j + 1) % 3])).normalized();
      normals[k][4 + j] = corners[at(t[j])].normalized();
    }
  }
  return normals;
}

class Mesh final : public Shape {
 public:
  explicit Mesh(TriangleMesh surface)
      : surface_(std::move(surface)),
        tree_(surface_),
        normals_(feature_normals(surface_)),
        solid_(mesh_solid(surface_)),
        area_(mesh_area(surface_)) {
    for (const Vec3& p : surface_.vertices) radius_ = std::max(radius_, p.norm());
  }

  SurfacePoint nearest(const Vec3& point) const override {
    return signed_point(point, tree_.nearest(point));
  }

  double segment_distance(const Vec3& a, const Vec3& b) const override {
    const double start = nearest(a).distance;
    if (start > 0.0) {
      const double clear = tree_.segment_distance(a, b, start);
      if (clear > touching()) return clear;
    }
    return deepest(a, b);
  }

  double bounding_radius() const override { return radius_; }
  SolidProperties solid() const override { return solid_; }
  double surface_area() const override { return area_; }
  TriangleMesh triangles() const override { return surface_; }

 private:
  // A point of the segment at t in [0, 1]; depth is minus the signed distance.
  struct Sample {
    double t;
    Vec3 point;
    double depth;
    Index triangle;
  };
  // A part of the segment between two samples, and an upper bound of the depth on it.
  struct Part {
    Sample left, right;
    double bound;
    bool operator<(const Part& other) const { return bound < other.bound; }
  };

  // Below this the segment may cross the surface.
  double touching() const { return 1e-12 * radius_; }

  SurfacePoint signed_point(const Vec3& point, const TriangleTree::Nearest& found) const {
    const Vec3& normal = normals_[at(found.triangle)][static_cast<std::size_t>(found.at.feature)];
    const Vec3 away = point - found.at.point;
    const double height = normal.dot(away);
    if (found.at.feature == Feature::face) return {height, normal, found.at.point};
    const double distance = height < 0.0 ? -found.distance : found.distance;
    // On the edge or corner itself the direction is lost to rounding.
    if (found.distance <= 1e-14 * radius_) return {distance, normal, found.at.point};
    return {distance, away / distance, found.at.point};
  }

  Sample sample(const Vec3& a, const Vec3& b, double t) const {
    const Vec3 point = a + t * (b - a);
    const TriangleTree::Nearest found = tree_.nearest(point);
    return {t, point, -signed_point(point, found).distance, found.triangle};
  }

  // The depth is at most the distance to any one triangle, a convex function along the segment and
  // so largest at an end; and it changes no faster than the point moves.
  Part part(const Sample& left, const Sample& right) const {
    const auto to = [&](Index triangle, const Vec3& p) {
      return (p - nearest_on_triangle(p, tree_.corners(triangle)).point).norm();
    };
    const double width = (right.point - left.point).norm();
    const double left_bound = std::max(std::abs(left.depth), to(left.triangle, right.point));
    const double right_bound = std::max(std::abs(right.depth), to(right.triangle, left.point));
    const double steady = 0.5 * (left.depth + right.depth + width);
    return {left, right, std::min({left_bound, right_bound, steady})};
  }

  // Minus the largest depth, by branch and bound.
  double deepest(const Vec3& a, const Vec3& b) const {
    const double tolerance = std::max(1e-7 * (b - a).norm(), 4.0 * touching());
    const Sample first = sample(a, b, 0.0), last = sample(a, b, 1.0);
    double best = std::max(first.depth, last.depth);
    std::priority_queue<Part> open;
    open.push(part(first, last));
    while (open.top().bound - best > tolerance) {
      const Part widest = open.top();
      open.pop();
      const Sample middle = sample(a, b, 0.5 * (widest.left.t + widest.right.t));
      best = std::max(best, middle.depth);
      open.push(part(widest.left, middle));
      open.push(part(middle, widest.right));
    }
    return -best;
  }

  TriangleMesh surface_;
  TriangleTree tree_;
  std::vector<FeatureNormals> normals_;
  SolidProperties solid_;
  double area_;
  double radius_ = 0.0;
};

}  // namespace

std::shared_ptr<const Shape> make_mesh(TriangleMesh surface) {
  return std::make_shared<Mesh>(std::move(surface));
}

}  // namespace retiarius

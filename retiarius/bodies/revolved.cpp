// Cylinder and cone: convex solids of revolution with a straight-edged meridian. The distance is
// that of the point's own meridian half-plane (r, z) to the convex meridian.
#include <algorithm>
#include <cmath>
#include <utility>

#include "retiarius/bodies/convex_search.hpp"
#include "retiarius/bodies/primitives.hpp"
#include "retiarius/bodies/revolved_triangles.hpp"

namespace retiarius {
namespace {

using Vec2 = Eigen::Vector2d;

// An edge of the meridian with its outward normal.
struct Edge {
  Vec2 start;
  Vec2 along;  // unit
  double length;
  Vec2 normal;
};

// Distance, normal and nearest point within the meridian half-plane.
struct FlatPoint {
  double distance = kInfinity;
  Vec2 normal = Vec2::Zero();
  Vec2 point = Vec2::Zero();
};

class Revolved final : public Shape {
 public:
  Revolved(Meridian meridian, const SolidProperties& solid, double area)
      : meridian_(std::move(meridian)), solid_(solid), area_(area) {
    for (std::size_t k = 0; k + 1 < meridian_.size(); ++k) {
      const Vec2 span = meridian_[k + 1] - meridian_[k];
      const Vec2 along = span.normalized();
      edges_.push_back({meridian_[k], along, span.norm(), Vec2(along.y(), -along.x())});
      radius_ = std::max(radius_, meridian_[k + 1].norm());
    }
  }

  SurfacePoint nearest(const Vec3& point) const override {
    const double r = std::hypot(point.x(), point.y());
    const Vec3 out = r > 0.0 ? Vec3(point.x() / r, point.y() / r, 0.0) : Vec3::UnitX();
    const Vec2 flat(r, point.z());
    const FlatPoint inside = nearest_line(flat);
    const FlatPoint found = inside.distance <= 0.0 ? inside : nearest_from_outside(flat);
    const auto lift = [&](const Vec2& q) -> Vec3 { return q.x() * out + q.y() * Vec3::UnitZ(); };
    return {found.distance, lift(found.normal), lift(found.point)};
  }

  double segment_distance(const Vec3& a, const Vec3& b) const override {
    return convex_segment_distance(*this, a, b);
  }

  double bounding_radius() const override { return radius_; }
  SolidProperties solid() const override { return solid_; }
  double surface_area() const override { return area_; }
  TriangleMesh triangles() const override { return revolved_triangles(meridian_); }

 private:
  // The edge whose line the point is least behind: exact for a point inside a convex meridian.
  FlatPoint nearest_line(const Vec2& p) const {
    FlatPoint best{-kInfinity, {}, {}};
    for (const Edge& edge : edges_) {
      const double height = edge.normal.dot(p - edge.start);
      if (height > best.distance) best = {height, edge.normal, p - height * edge.normal};
    }
    return best;
  }

  FlatPoint nearest_from_outside(const Vec2& p) const {
    FlatPoint best;
    for (const Edge& edge : edges_) {
      const double t = edge.along.dot(p - edge.start);
      const Vec2 foot = edge.start + std::clamp(t, 0.0, edge.length) * edge.along;
      const Vec2 away = p - foot;
      const bool beside = t >= 0.0 && t <= edge.length;
      const double distance = beside ? std::abs(edge.normal.dot(p - edge.start)) : away.norm();
      if (distance >= best.distance) continue;
      // At a vertex itself the direction is lost to rounding; the edge's normal is one of its own.
      const bool exact = beside || distance <= 1e-14 * radius_;
      best = {distance, exact ? edge.normal : Vec2(away / distance), foot};
    }
    return best;
  }

  Meridian meridian_;
  std::vector<Edge> edges_;
  SolidProperties solid_;
  double area_;
  double radius_ = 0.0;
};

}  // namespace

std::shared_ptr<const Shape> make_cylinder(double radius, double length) {
  const double r2 = radius * radius;
  const double volume = kPi * r2 * length;
  const double transverse = volume * (3.0 * r2 + length * length) / 12.0;
  const Mat3 inertia = Vec3(transverse, transverse, 0.5 * volume * r2).asDiagonal();
  const double half = 0.5 * length;
  return std::make_shared<Revolved>(
      Meridian{{0, -half}, {radius, -half}, {radius, half}, {0, half}},
      SolidProperties{volume, Vec3::Zero(), inertia}, 2.0 * kPi * radius * (radius + length));
}

std::shared_ptr<const Shape> make_cone(double radius, double length) {
  const double r2 = radius * radius;
  const double volume = kPi * r2 * length / 3.0;
  const double transverse = 3.0 / 80.0 * volume * (4.0 * r2 + length * length);
  const Mat3 inertia = Vec3(transverse, transverse, 0.3 * volume * r2).asDiagonal();
  const double base = -0.25 * length;
  return std::make_shared<Revolved>(Meridian{{0, base}, {radius, base}, {0, 0.75 * length}},
                                    SolidProperties{volume, Vec3::Zero(), inertia},
                                    kPi * radius * (radius + std::hypot(radius, length)));
}

}  // namespace retiarius

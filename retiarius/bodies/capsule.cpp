#include <algorithm>
#include <cmath>

#include "retiarius/bodies/convex_search.hpp"
#include "retiarius/bodies/primitives.hpp"
#include "retiarius/bodies/revolved_triangles.hpp"

namespace retiarius {
namespace {

class Capsule final : public Shape {
 public:
  Capsule(double radius, double length) : radius_(radius), half_(0.5 * length) {}

  SurfacePoint nearest(const Vec3& point) const override {
    const Vec3 foot(0.0, 0.0, std::clamp(point.z(), -half_, half_));
    const Vec3 away = point - foot;
    const double distance = away.norm();
    const Vec3 normal = distance > 0.0 ? Vec3(away / distance) : Vec3::UnitX();
    return {distance - radius_, normal, foot + radius_ * normal};
  }

  double segment_distance(const Vec3& a, const Vec3& b) const override {
    return convex_segment_distance(*this, a, b);
  }

  double bounding_radius() const override { return half_ + radius_; }

  // Cylinder and two half balls; a half ball's centroid lies 3/8 r from its flat side, and its
  // transverse inertia about the ball's centre is 2/5 m r2.
  SolidProperties solid() const override {
    const double r2 = radius_ * radius_;
    const double length = 2.0 * half_;
    const double tube = kPi * r2 * length;
    const double ball = 4.0 / 3.0 * kPi * r2 * radius_;
    const double axial = tube * r2 / 2.0 + ball * 0.4 * r2;
    const double transverse = tube * (r2 / 4.0 + length * length / 12.0) +
                              ball * (0.4 * r2 + half_ * half_ + 2.0 * half_ * 0.375 * radius_);
    return {tube + ball, Vec3::Zero(), Vec3(transverse, transverse, axial).asDiagonal()};
  }

  double surface_area() const override {
    return 2.0 * kPi * radius_ * (2.0 * half_) + 4.0 * kPi * radius_ * radius_;
  }

  TriangleMesh triangles() const override {
    return revolved_triangles(capsule_meridian(radius_, 2.0 * half_));
  }

 private:
  double radius_;
  double half_;
};

}  // namespace

std::shared_ptr<const Shape> make_capsule(double radius, double length) {
  return std::make_shared<Capsule>(radius, length);
}

}  // namespace retiarius

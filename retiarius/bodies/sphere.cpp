#include <algorithm>

#include "retiarius/bodies/primitives.hpp"
#include "retiarius/bodies/revolved_triangles.hpp"

namespace retiarius {
namespace {

class Sphere final : public Shape {
 public:
  explicit Sphere(double radius) : radius_(radius) {}

  SurfacePoint nearest(const Vec3& point) const override {
    const double length = point.norm();
    const Vec3 normal = length > 0.0 ? Vec3(point / length) : Vec3::UnitZ();
    return {length - radius_, normal, radius_ * normal};
  }

  double segment_distance(const Vec3& a, const Vec3& b) const override {
    const Vec3 d = b - a;
    const double dd = d.squaredNorm();
    const double t = dd > 0.0 ? std::clamp(-a.dot(d) / dd, 0.0, 1.0) : 0.0;
    return (a + t * d).norm() - radius_;
  }

  double bounding_radius() const override { return radius_; }

  SolidProperties solid() const override {
    const double volume = 4.0 / 3.0 * kPi * radius_ * radius_ * radius_;
    return {volume, Vec3::Zero(), 0.4 * volume * radius_ * radius_ * Mat3::Identity()};
  }

  double surface_area() const override { return 4.0 * kPi * radius_ * radius_; }

  TriangleMesh triangles() const override {
    return revolved_triangles(capsule_meridian(radius_, 0.0));
  }

 private:
  double radius_;
};

}  // namespace

std::shared_ptr<const Shape> make_sphere(double radius) { return std::make_shared<Sphere>(radius); }

}  // namespace retiarius

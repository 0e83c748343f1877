#include <algorithm>

#include "retiarius/bodies/primitives.hpp"

namespace retiarius {
namespace {

class Plane final : public Shape {
 public:
  SurfacePoint nearest(const Vec3& point) const override {
    return {point.z(), Vec3::UnitZ(), Vec3(point.x(), point.y(), 0.0)};
  }
  double segment_distance(const Vec3& a, const Vec3& b) const override {
    return std::min(a.z(), b.z());
  }
  double bounding_radius() const override { return kInfinity; }
  SolidProperties solid() const override { return {kInfinity, Vec3::Zero(), Mat3::Zero()}; }
  double surface_area() const override { return kInfinity; }
  TriangleMesh triangles() const override {
    constexpr double kHalf = 10.0;
    return {{{-kHalf, -kHalf, 0}, {kHalf, -kHalf, 0}, {kHalf, kHalf, 0}, {-kHalf, kHalf, 0}},
            {{0, 1, 2}, {0, 2, 3}}};
  }
};

}  // namespace

std::shared_ptr<const Shape> make_plane() { return std::make_shared<Plane>(); }

}  // namespace retiarius

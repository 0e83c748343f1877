#include <algorithm>
#include <cmath>

#include "retiarius/bodies/convex_search.hpp"
#include "retiarius/bodies/primitives.hpp"

namespace retiarius {
namespace {

class Box final : public Shape {
 public:
  explicit Box(const Vec3& size) : half_(0.5 * size) {}

  SurfacePoint nearest(const Vec3& point) const override {
    const Vec3 beyond = point.cwiseAbs() - half_;
    if (beyond.maxCoeff() <= 0.0) return nearest_from_inside(point, beyond);
    const Vec3 foot = point.cwiseMax(-half_).cwiseMin(half_);
    const Vec3 away = point - foot;
    const double distance = away.norm();
    return {distance, away / distance, foot};
  }

  double segment_distance(const Vec3& a, const Vec3& b) const override {
    return convex_segment_distance(*this, a, b);
  }

  double bounding_radius() const override { return half_.norm(); }

  SolidProperties solid() const override {
    const Vec3 size = 2.0 * half_;
    const double volume = size.prod();
    const Vec3 squares = size.cwiseProduct(size);
    const Vec3 inertia = volume / 12.0 * (Vec3::Constant(squares.sum()) - squares);
    return {volume, Vec3::Zero(), inertia.asDiagonal()};
  }

  double surface_area() const override {
    return 8.0 * (half_.x() * half_.y() + half_.y() * half_.z() + half_.z() * half_.x());
  }

  TriangleMesh triangles() const override {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 sign((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
      mesh.vertices.push_back(half_.cwiseProduct(sign));
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
  }

 private:
  SurfacePoint nearest_from_inside(const Vec3& point, const Vec3& beyond) const {
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (beyond[k] > beyond[axis]) axis = k;
    }
    const double sign = point[axis] < 0.0 ? -1.0 : 1.0;
    SurfacePoint result{beyond[axis], Vec3::Zero(), point};
    result.normal[axis] = sign;
    result.point[axis] = sign * half_[axis];
    return result;
  }

  Vec3 half_;
};

}  // namespace

std::shared_ptr<const Shape> make_box(const Vec3& size) { return std::make_shared<Box>(size); }

}  // namespace retiarius

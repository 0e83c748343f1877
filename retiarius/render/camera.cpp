#include "retiarius/render/camera.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius::render {

namespace {

constexpr double kDistance = 3.4;  // in radii: a moderate perspective

Vec3 axis_of(View view) {
  switch (view) {
    case View::front:
      return -Vec3::UnitY();
    case View::side:
      return Vec3::UnitX();
    case View::top:
      return Vec3::UnitZ();
    case View::iso:
      break;
  }
  const double azimuth = radians(-58.0), elevation = radians(22.0);
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

}  // namespace

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names = {"iso", "front", "side", "top"};
  return names;
}

View view_named(const std::string& name) {
  const auto& names = view_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError(
        fmt::format("there is no view {}; there are {}", name, fmt::join(names, ", ")));
  return static_cast<View>(found - names.begin());
}

Camera::Camera(View view, const std::vector<Vec3>& points, const Area& area)
    : axis_(axis_of(view)) {
  right_ = view == View::top ? Vec3(Vec3::UnitX()) : Vec3::UnitZ().cross(axis_).normalized();
  up_ = axis_.cross(right_);
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  if (!points.empty()) low = high = points[0];
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  radius_ = std::max(0.5 * (high - low).norm(), 1e-6);
  distance_ = kDistance * radius_;
  eye_ = 0.5 * (low + high) + distance_ * axis_;
  // The outline on paper for a focal length of one, then what makes it fill the area.
  double left = kInfinity, right = -kInfinity, bottom = kInfinity, top = -kInfinity;
  for (const Vec3& x : points) {
    const Place p = place(x);
    left = std::min(left, p.x), right = std::max(right, p.x);
    bottom = std::min(bottom, -p.y), top = std::max(top, -p.y);
  }
  if (points.empty()) left = bottom = 0.0, right = top = 0.0;
  const double least = 0.02 / kDistance;  // of points that all lie in one place on paper
  focal_ = std::min(area.width / std::max(right - left, least),
                    area.height / std::max(top - bottom, least));
  x_ = area.x + 0.5 * area.width - 0.5 * focal_ * (left + right);
  y_ = area.y + 0.5 * area.height + 0.5 * focal_ * (bottom + top);
}

Place Camera::place(const Vec3& x) const {
  const Vec3 from_eye = x - eye_;
  const double depth = std::max(-from_eye.dot(axis_), 1e-3 * distance_);
  const double scale = focal_ / depth;
  return {x_ + scale * from_eye.dot(right_), y_ - scale * from_eye.dot(up_), depth, scale};
}

Vec3 Camera::lamp() const { return (axis_ + 0.9 * up_ - 0.55 * right_).normalized(); }

}  // namespace retiarius::render

#include "retiarius/render/depth_map.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius::render {

DepthMap::DepthMap(const Area& area)
    : x_(area.x),
      y_(area.y),
      columns_(std::max(1, static_cast<int>(std::ceil(area.width)))),
      rows_(std::max(1, static_cast<int>(std::ceil(area.height)))),
      nearness_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0.0f) {}

void DepthMap::add(const std::array<Place, 3>& t) {
  const auto cross = [](const Place& a, const Place& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  const double area = cross(t[0], t[1], t[2].x, t[2].y);
  if (std::abs(area) < 1e-12) return;
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  const int c0 = std::max(0, static_cast<int>(std::floor(left - x_)));
  const int c1 = std::min(columns_ - 1, static_cast<int>(std::floor(right - x_)));
  const int r0 = std::max(0, static_cast<int>(std::floor(top - y_)));
  const int r1 = std::min(rows_ - 1, static_cast<int>(std::floor(bottom - y_)));
  for (int r = r0; r <= r1; ++r)
    for (int c = c0; c <= c1; ++c) {
      const double x = x_ + c + 0.5, y = y_ + r + 0.5;
      const double u = cross(t[1], t[2], x, y) / area, v = cross(t[2], t[0], x, y) / area;
      const double w = 1.0 - u - v;
      if (u < 0.0 || v < 0.0 || w < 0.0) continue;
      const auto nearness = static_cast<float>(u / t[0].depth + v / t[1].depth + w / t[2].depth);
      float& cell = nearness_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                              static_cast<std::size_t>(c)];
      cell = std::max(cell, nearness);
    }
}

bool DepthMap::hides(const Place& place, double tolerance) const {
  const double c = std::floor(place.x - x_), r = std::floor(place.y - y_);
  if (!(c >= 0 && r >= 0 && c < columns_ && r < rows_)) return false;
  const double nearness =
      nearness_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(c)];
  return nearness > 0.0 && 1.0 / nearness < place.depth - tolerance;
}

}  // namespace retiarius::render

#include "retiarius/check/plain_distance.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius::check {

double point_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length = (b - a).norm();
  if (length == 0.0) return (p - a).norm();
  const Vec3 way = (b - a) / length;
  const double along = std::min(std::max(way.dot(p - a), 0.0), length);
  return (p - (a + along * way)).norm();
}

double segment_segment(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double least = std::min({point_segment(a, c, d), point_segment(b, c, d), point_segment(c, a, b),
                           point_segment(d, a, b)});
  // Where the common normal meets both inside: seen along it, the lines cross.
  const Vec3 normal = (b - a).cross(d - c);
  const double length = normal.norm();
  if (length == 0.0) return least;
  const Vec3 n = normal / length;
  const Vec3 across_first = n.cross(b - a), across_second = n.cross(d - c);
  const bool second_straddles = across_first.dot(c - a) * across_first.dot(d - a) < 0.0;
  const bool first_straddles = across_second.dot(a - c) * across_second.dot(b - c) < 0.0;
  if (first_straddles && second_straddles) least = std::min(least, std::abs(n.dot(c - a)));
  return least;
}

double point_triangle(const Vec3& p, const Triangle& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double area = normal.norm();
  if (area > 0.0) {
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& corner = t[k];
      inside = inside && normal.dot((t[(k + 1) % 3] - corner).cross(p - corner)) >= 0.0;
    }
    if (inside) return std::abs(normal.dot(p - t[0])) / area;
  }
  return std::min(
      {point_segment(p, t[0], t[1]), point_segment(p, t[1], t[2]), point_segment(p, t[2], t[0])});
}

double segment_triangle(const Vec3& a, const Vec3& b, const Triangle& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double from = normal.dot(a - t[0]), to = normal.dot(b - t[0]);
  if (from * to <= 0.0 && from != to) {
    const Vec3 hit = a + from / (from - to) * (b - a);
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k)
      inside = inside && normal.dot((t[(k + 1) % 3] - t[k]).cross(hit - t[k])) >= 0.0;
    if (inside) return 0.0;
  }
  double least = std::min(point_triangle(a, t), point_triangle(b, t));
  for (std::size_t k = 0; k < 3; ++k)
    least = std::min(least, segment_segment(a, b, t[k], t[(k + 1) % 3]));
  return least;
}

double winding_number(const Vec3& p, const std::vector<Triangle>& surface) {
  double angle = 0.0;
  for (const Triangle& t : surface) {
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * kPi);
}

}  // namespace retiarius::check

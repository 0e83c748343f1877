#include "retiarius/bodies/triangle_nearest.hpp"

#include <algorithm>

namespace retiarius {

TrianglePoint nearest_on_triangle(const Vec3& p, const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, Feature::corner0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, Feature::corner1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + d1 / (d1 - d3) * ab, Feature::edge0};
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, Feature::corner2};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + d2 / (d2 - d6) * ac, Feature::edge2};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), Feature::edge1};
  }
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, Feature::face};
}

double segment_segment_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, w = d - c, r = a - c;
  const double uu = u.squaredNorm(), ww = w.squaredNorm(), wr = w.dot(r);
  double s = 0.0, t = 0.0;
  if (ww > 0.0) {
    const double ur = u.dot(r), uw = u.dot(w);
    const double denominator = uu * ww - uw * uw;
    if (denominator > 0.0) s = std::clamp((uw * wr - ur * ww) / denominator, 0.0, 1.0);
    t = (uw * s + wr) / ww;
    if (t < 0.0 || t > 1.0) {
      t = std::clamp(t, 0.0, 1.0);
      s = uu > 0.0 ? std::clamp((uw * t - ur) / uu, 0.0, 1.0) : 0.0;
    }
  } else if (uu > 0.0) {
    s = std::clamp(-u.dot(r) / uu, 0.0, 1.0);
  }
  return (r + s * u - t * w).norm();
}

double segment_triangle_distance(const Vec3& a, const Vec3& b, const Corners& triangle) {
  double least = std::min((a - nearest_on_triangle(a, triangle).point).norm(),
                          (b - nearest_on_triangle(b, triangle).point).norm());
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, segment_segment_distance(a, b, triangle[k], triangle[(k + 1) % 3]));
  }
  // Where the segment pierces the plane.
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double ha = normal.dot(a - triangle[0]), hb = normal.dot(b - triangle[0]);
  if ((ha > 0.0) != (hb > 0.0)) {
    const Vec3 pierced = a + ha / (ha - hb) * (b - a);
    least = std::min(least, (pierced - nearest_on_triangle(pierced, triangle).point).norm());
  }
  return least;
}

}  // namespace retiarius

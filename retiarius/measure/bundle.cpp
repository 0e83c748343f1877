#include "retiarius/measure/bundle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace retiarius {

namespace {

using Vec2 = Eigen::Vector2d;

// A point this share outside still counts as held: the circle's own round-off.
bool holds(const Circle& c, const Vec2& p) {
  return (p - c.center).norm() <= c.radius * (1.0 + 1e-12) + 1e-300;
}

Circle through(const Vec2& a, const Vec2& b) { return {0.5 * (a + b), 0.5 * (a - b).norm()}; }

Circle through(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  const double d = 2.0 * (u.x() * v.y() - u.y() * v.x());
  if (d == 0.0) {  // on one line: the farthest two span it
    Circle best = through(a, b);
    for (const Circle& other : {through(a, c), through(b, c)})
      if (other.radius > best.radius) best = other;
    return best;
  }
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const Vec2 offset((v.y() * uu - u.y() * vv) / d, (u.x() * vv - v.x() * uu) / d);
  return {a + offset, offset.norm()};
}

// A fixed permutation, so that sorted input does not cost quadratic time.
void shuffle(std::vector<Vec2>& points) {
  std::uint64_t s = 0x9E3779B97F4A7C15ull;
  for (std::size_t i = points.size(); i > 1; --i) {
    s = s * 6364136223846793005ull + 1442695040888963407ull;
    std::swap(points[i - 1], points[(s >> 33) % i]);
  }
}

}  // namespace

Circle smallest_circle(std::vector<Vec2> points) {
  shuffle(points);
  Circle c;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && holds(c, points[i])) continue;
    c = {points[i], 0.0};
    for (std::size_t j = 0; j < i; ++j) {
      if (holds(c, points[j])) continue;
      c = through(points[i], points[j]);
      for (std::size_t k = 0; k < j; ++k)
        if (!holds(c, points[k])) c = through(points[i], points[j], points[k]);
    }
  }
  return c;
}

Bundle measure_bundle(const Network& network, const std::vector<Vec3>& x, const Vec3& axis) {
  const Vec3 a = axis.normalized();
  const Vec3 u = a.unitOrthogonal();
  const Vec3 v = a.cross(u);
  std::vector<Eigen::Vector2d> flat;
  double low = kInfinity;
  double high = -kInfinity;
  for (const Vec3& p : x) {
    flat.emplace_back(u.dot(p), v.dot(p));
    low = std::min(low, a.dot(p));
    high = std::max(high, a.dot(p));
  }
  double radius = 0.0;
  double volume = 0.0;
  for (const Segment& s : network.segments) {
    const double r = network.materials[s.material].radius;
    radius = std::max(radius, r);
    volume += kPi * r * r * s.rest_length;
  }
  Bundle b;
  b.diameter = 2.0 * (smallest_circle(std::move(flat)).radius + radius);
  b.height = high - low + 2.0 * radius;
  b.packing_ratio = volume / (0.25 * kPi * b.diameter * b.diameter * b.height);
  return b;
}

}  // namespace retiarius

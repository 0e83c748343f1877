// Distances of primitives in quadruple precision, by trying every feature: what the library's
// distances and derivatives are compared with.
#pragma once

#include <array>
#include <cmath>

#include "retiarius/contact/contact_pair.hpp"

namespace retiarius::testing {

__extension__ using Quad = __float128;

struct QuadVec {
  Quad x = 0, y = 0, z = 0;
  QuadVec() = default;
  QuadVec(Quad a, Quad b, Quad c) : x(a), y(b), z(c) {}
  explicit QuadVec(const Vec3& v) : x(v.x()), y(v.y()), z(v.z()) {}
  QuadVec operator+(const QuadVec& o) const { return {x + o.x, y + o.y, z + o.z}; }
  QuadVec operator-(const QuadVec& o) const { return {x - o.x, y - o.y, z - o.z}; }
  Quad dot(const QuadVec& o) const { return x * o.x + y * o.y + z * o.z; }
  QuadVec cross(const QuadVec& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
  Quad& operator[](int k) { return k == 0 ? x : k == 1 ? y : z; }
};
inline QuadVec operator*(Quad s, const QuadVec& v) { return {s * v.x, s * v.y, s * v.z}; }

using QuadPositions = std::array<QuadVec, 4>;

inline QuadPositions quad(const PairPositions& p) {
  return {QuadVec(p[0]), QuadVec(p[1]), QuadVec(p[2]), QuadVec(p[3])};
}

inline Quad root(Quad value) {
  if (!(value > 0)) return 0;
  Quad guess = std::sqrt(static_cast<long double>(value));
  for (int k = 0; k < 3; ++k) guess = (guess + value / guess) / 2;
  return guess;
}

// Squares of distances.
inline Quad exact_point_edge(const QuadVec& p, const QuadVec& a, const QuadVec& b) {
  const QuadVec along = b - a;
  const Quad length2 = along.dot(along);
  Quad t = length2 > 0 ? (p - a).dot(along) / length2 : Quad(0);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const QuadVec u = p - a - t * along;
  return u.dot(u);
}

inline Quad exact_point_triangle(const QuadPositions& p) {
  Quad best = exact_point_edge(p[0], p[1], p[2]);
  const auto take = [&](Quad other) {
    if (other < best) best = other;
  };
  take(exact_point_edge(p[0], p[2], p[3]));
  take(exact_point_edge(p[0], p[3], p[1]));
  const QuadVec n = (p[2] - p[1]).cross(p[3] - p[1]);
  const Quad area2 = n.dot(n);
  if (!(area2 > 0)) return best;
  const bool inside = (p[2] - p[1]).cross(p[0] - p[1]).dot(n) >= 0 &&
                      (p[3] - p[2]).cross(p[0] - p[2]).dot(n) >= 0 &&
                      (p[1] - p[3]).cross(p[0] - p[3]).dot(n) >= 0;
  if (inside) {
    const Quad height = n.dot(p[0] - p[1]);
    take(height * height / area2);
  }
  return best;
}

inline Quad exact_edge_edge(const QuadPositions& p) {
  Quad best = exact_point_edge(p[0], p[2], p[3]);
  const auto take = [&](Quad other) {
    if (other < best) best = other;
  };
  take(exact_point_edge(p[1], p[2], p[3]));
  take(exact_point_edge(p[2], p[0], p[1]));
  take(exact_point_edge(p[3], p[0], p[1]));
  const QuadVec a = p[1] - p[0], b = p[3] - p[2], r = p[2] - p[0];
  const QuadVec n = a.cross(b);
  const Quad n2 = n.dot(n);
  if (!(n2 > 0)) return best;
  const Quad s = r.cross(b).dot(n) / n2, t = r.cross(a).dot(n) / n2;
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
    const Quad height = n.dot(r);
    take(height * height / n2);
  }
  return best;
}

inline Quad exact_distance(PairKind kind, const QuadPositions& p) {
  switch (kind) {
    case PairKind::point_point:
      return root((p[0] - p[1]).dot(p[0] - p[1]));
    case PairKind::point_edge:
      return root(exact_point_edge(p[0], p[1], p[2]));
    case PairKind::point_triangle:
      return root(exact_point_triangle(p));
    case PairKind::edge_edge:
      return root(exact_edge_edge(p));
    case PairKind::point_plane:
      break;
  }
  return (p[2] - p[1]).dot(p[0] - p[1]);
}

}  // namespace retiarius::testing

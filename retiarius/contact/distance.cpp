#include "retiarius/contact/distance.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {
namespace {

constexpr double kSmallestSine = 1e-10;  // of edges whose interiors are compared

// Of edges whose places inside both are nearest beyond doubt, so that no end need be looked at.
constexpr double kClearSine = 1e-3;

// Of squares of distances, relative, with room to spare.
constexpr double kSquareRounding = 1e-12;

// Any unit vector across `along`, which need not be a unit vector.
Vec3 any_normal(const Vec3& along) {
  if (along.isZero(0.0)) return Vec3::UnitZ();
  return along.unitOrthogonal();
}

// The share t in [0, 1] of the place on a-b nearest to p; 0 for a = b.
double nearest_share(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  if (!(length2 > 0.0)) return 0.0;
  return std::clamp((p - a).dot(along) / length2, 0.0, 1.0);
}

std::uint8_t active_of(const std::array<double, 4>& weight) {
  std::uint8_t active = 0;
  for (int i = 0; i < 4; ++i) {
    if (weight[static_cast<std::size_t>(i)] != 0.0) active |= static_cast<std::uint8_t>(1u << i);
  }
  return active;
}

// The difference of the closest points, from differences of positions, not from positions.
Vec3 difference(const std::array<double, 4>& w, const PairPositions& p) {
  Vec3 u = Vec3::Zero();
  for (std::size_t i = 1; i < 4; ++i) {
    if (w[i] != 0.0) u += w[i] * (p[i] - p[0]);
  }
  return u;
}

// Distance for given weights, whose difference of points is across the features that meet. Near 0
// the direction of that difference is lost to rounding; `across` (0: none) is a direction that the
// features have in common as their normal and `sine` how well it is known: the sine of the angle of
// the vectors that it is made of.
Distance finish(const std::array<double, 4>& w, const PairPositions& p, const Vec3& across,
                double sine, double extent) {
  Distance out;
  out.weight = w;
  out.active = active_of(w);
  const Vec3 u = difference(w, p);
  const double length = u.norm();
  if (!across.isZero(0.0) && sine * extent > length) {
    out.normal = across.dot(u) < 0.0 ? Vec3(-across) : across;
    out.value = std::max(0.0, out.normal.dot(u));
  } else {
    out.value = length;
    out.normal = length > 0.0 ? Vec3(u / length) : Vec3::UnitZ();
  }
  return out;
}

// One free parameter: the difference is across `along`; rounding along it is taken out.
Distance finish_on_edge(const std::array<double, 4>& w, const PairPositions& p, const Vec3& along,
                        const Vec3& spare) {
  Distance out;
  out.weight = w;
  out.active = active_of(w);
  const Vec3 u = difference(w, p);
  const Vec3 e = along.normalized();
  const Vec3 across = u - u.dot(e) * e;
  out.value = across.norm();
  if (out.value > 0.0) {
    out.normal = across / out.value;
  } else {
    const Vec3 other = spare.cross(along);
    out.normal = other.isZero(0.0) ? any_normal(along) : Vec3(other.normalized());
  }
  return out;
}

Distance point_point(const PairPositions& p, std::size_t i, std::size_t j) {
  std::array<double, 4> w{};
  w[i] = 1.0;
  w[j] = -1.0;
  Distance out;
  out.weight = w;
  out.active = active_of(w);
  const Vec3 u = p[i] - p[j];
  out.value = u.norm();
  out.normal = out.value > 0.0 ? Vec3(u / out.value) : Vec3::UnitZ();
  return out;
}

// Point i against edge a-b; sign is 1 where the point is of the first primitive, else -1.
Distance point_edge(const PairPositions& p, std::size_t i, std::size_t a, std::size_t b,
                    double sign, const Vec3& spare) {
  const double t = nearest_share(p[i], p[a], p[b]);
  if (t == 0.0) return sign > 0.0 ? point_point(p, i, a) : point_point(p, a, i);
  if (t == 1.0) return sign > 0.0 ? point_point(p, i, b) : point_point(p, b, i);
  std::array<double, 4> w{};
  w[i] = sign;
  w[a] = -sign * (1.0 - t);
  w[b] = -sign * t;
  return finish_on_edge(w, p, p[b] - p[a], spare);
}

double extent_of(const PairPositions& p, int count) {
  double extent = 0.0;
  for (int i = 1; i < count; ++i)
    extent = std::max(extent, (p[static_cast<std::size_t>(i)] - p[0]).norm());
  return extent;
}

// Of a thin triangle the shares w of its corners are uncertain. Moving the place along the longest
// edge until it lies below the point leaves an error of rounding only. False where it leaves the
// triangle.
bool settle_in_triangle(std::array<double, 4>& w, const PairPositions& p) {
  const double sum = w[1] + w[2] + w[3];
  for (std::size_t i = 1; i < 4; ++i) w[i] /= -sum;
  std::size_t from = 1, to = 2;
  for (const auto& [a, b] : {std::array<std::size_t, 2>{2, 3}, std::array<std::size_t, 2>{1, 3}}) {
    if ((p[b] - p[a]).squaredNorm() > (p[to] - p[from]).squaredNorm()) from = a, to = b;
  }
  const Vec3 along = p[to] - p[from];
  const double shift = difference(w, p).dot(along) / along.squaredNorm();
  w[to] -= shift;
  w[from] += shift;
  return w[to] < 0.0 && w[from] < 0.0;
}

Distance point_triangle(const PairPositions& p) {
  const Vec3 ab = p[2] - p[1], ac = p[3] - p[1], bc = p[3] - p[2];
  const Vec3 area = ab.cross(ac);
  const double area2 = area.squaredNorm();
  if (area2 > 0.0) {
    // Shares of the corners by the areas opposite to them.
    const double wa = bc.cross(p[0] - p[2]).dot(area) / area2;
    const double wb = (p[0] - p[1]).cross(ac).dot(area) / area2;
    const double wc = ab.cross(p[0] - p[1]).dot(area) / area2;
    std::array<double, 4> w{1.0, -wa, -wb, -wc};
    if (wa > 0.0 && wb > 0.0 && wc > 0.0 && settle_in_triangle(w, p)) {
      const double norm = std::sqrt(area2);
      const double sine = norm / std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()});
      return finish(w, p, area / norm, sine, extent_of(p, 4));
    }
  }
  Distance best = point_edge(p, 0, 1, 2, 1.0, area);
  for (const auto& [a, b] : {std::array<std::size_t, 2>{2, 3}, std::array<std::size_t, 2>{3, 1}}) {
    const Distance other = point_edge(p, 0, a, b, 1.0, area);
    if (other.value < best.value) best = other;
  }
  return best;
}

// The interiors of two edges: true where their closest places lie strictly inside both.
bool inside_both(const PairPositions& p, const Vec3& cross, double& s, double& t) {
  const Vec3 a = p[1] - p[0], b = p[3] - p[2], r = p[2] - p[0];
  const double cross2 = cross.squaredNorm();
  s = r.cross(b).dot(cross) / cross2;
  if (!(s > 0.0 && s < 1.0)) return false;
  // For nearly parallel edges s is uncertain, but the places are nearest all the same once each
  // lies below the other.
  t = (s * a - r).dot(b) / b.squaredNorm();
  if (!(t > 0.0 && t < 1.0)) return false;
  s = (t * b + r).dot(a) / a.squaredNorm();
  return s > 0.0 && s < 1.0;
}

// An end of one edge against the other edge: point i against a-b, see point_edge().
struct EndAgainstEdge {
  std::size_t i, a, b;
  double sign;
};
constexpr std::array<EndAgainstEdge, 4> kEnds{
    {{0, 2, 3, 1.0}, {1, 2, 3, 1.0}, {2, 0, 1, -1.0}, {3, 0, 1, -1.0}}};

// The nearest of the four. Squares, known to rounding, sort out those that are clearly farther. Not
// a number where a position is none, lest it count as far.
Distance nearest_end(const PairPositions& p, const Vec3& cross, double extent2) {
  std::array<double, 4> square;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto [i, a, b, sign] = kEnds[k];
    const double t = nearest_share(p[i], p[a], p[b]);
    square[k] = ((1.0 - t) * (p[a] - p[i]) + t * (p[b] - p[i])).squaredNorm();
  }
  const double least = *std::min_element(square.begin(), square.end());
  const double limit =
      (1.0 + kSquareRounding) * least + kSquareRounding * kSquareRounding * extent2;
  Distance best;
  best.value = kInfinity;
  if (const double sum = square[0] + square[1] + square[2] + square[3]; std::isnan(sum)) {
    best.value = sum;
    return best;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (square[k] > limit) continue;
    const auto [i, a, b, sign] = kEnds[k];
    const Distance other = point_edge(p, i, a, b, sign, cross);
    if (other.value < best.value) best = other;
  }
  return best;
}

Distance edge_edge(const PairPositions& p) {
  const Vec3 a = p[1] - p[0], b = p[3] - p[2];
  const Vec3 cross = a.cross(b);
  const double scale = std::sqrt(a.squaredNorm() * b.squaredNorm());
  const double size = cross.norm();
  const double sine = scale > 0.0 ? size / scale : 0.0;
  double s = 0.0, t = 0.0;
  Distance inner;
  inner.value = kInfinity;
  if (sine > kSmallestSine && inside_both(p, cross, s, t)) {
    inner = finish({1.0 - s, s, t - 1.0, -t}, p, cross / size, sine, extent_of(p, 4));
    if (sine > kClearSine) return inner;
  }
  const double extent2 = std::max(a.squaredNorm(), b.squaredNorm());
  const Distance best = nearest_end(p, cross, extent2);
  return inner.value <= best.value ? inner : best;
}

Distance point_plane(const PairPositions& p) {
  Distance out;
  out.normal = p[2] - p[1];
  out.value = out.normal.dot(p[0] - p[1]);
  out.weight[0] = 1.0;
  out.active = 1;
  return out;
}

}  // namespace

Distance distance(PairKind kind, const PairPositions& p) {
  switch (kind) {
    case PairKind::point_point:
      return point_point(p, 0, 1);
    case PairKind::point_edge:
      return point_edge(p, 0, 1, 2, 1.0, Vec3::Zero());
    case PairKind::point_triangle:
      return point_triangle(p);
    case PairKind::edge_edge:
      return edge_edge(p);
    case PairKind::point_plane:
      break;
  }
  return point_plane(p);
}

}  // namespace retiarius

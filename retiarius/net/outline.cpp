#include "retiarius/net/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace retiarius {
namespace {

double cross(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Angle from the reference, in [0, 2 pi).
double turn_from(double reference, double angle) {
  const double turn = std::fmod(angle - reference, 2.0 * kPi);
  return turn < 0.0 ? turn + 2.0 * kPi : turn;
}

double heading(const Vec3& from, const Vec3& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

// The pieces that meet in each node, in compressed rows.
struct Incidence {
  std::vector<std::size_t> start;
  std::vector<Index> pieces;
};

Incidence incidence(const Layout& layout, bool border_only) {
  Incidence result;
  result.start.assign(layout.nodes.size() + 1, 0);
  const auto wanted = [&](const Piece& piece) { return piece.border || !border_only; };
  for (const Piece& piece : layout.pieces) {
    if (!wanted(piece)) continue;
    ++result.start[piece.a + 1];
    ++result.start[piece.b + 1];
  }
  std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
  result.pieces.resize(result.start.back());
  std::vector<std::size_t> next(result.start.begin(), result.start.end() - 1);
  for (std::size_t i = 0; i < layout.pieces.size(); ++i) {
    const Piece& piece = layout.pieces[i];
    if (!wanted(piece)) continue;
    result.pieces[next[piece.a]++] = static_cast<Index>(i);
    result.pieces[next[piece.b]++] = static_cast<Index>(i);
  }
  return result;
}

Index other_end(const Piece& piece, Index node) { return piece.a == node ? piece.b : piece.a; }

// Walks the outer face with the net on the left: in each node the next piece is the first one
// counter-clockwise from where the walk came. Stops at the first node met twice.
std::vector<Index> walk(const Layout& layout, const Incidence& around, Index start) {
  std::vector<char> seen(layout.nodes.size(), 0);
  std::vector<Index> loop;
  double back = -kPi / 2.0;  // no piece leads down from the lowest node
  for (Index node = start; !seen[node];) {
    seen[node] = 1;
    Index best = kNone;
    double least = kInfinity;
    for (std::size_t k = around.start[node]; k < around.start[node + 1]; ++k) {
      const Index piece = around.pieces[k];
      if (!loop.empty() && piece == loop.back()) continue;
      const Index end = other_end(layout.pieces[piece], node);
      const double turn = turn_from(back, heading(layout.nodes[node], layout.nodes[end]));
      if (turn < least) {
        least = turn;
        best = piece;
      }
    }
    if (best == kNone) return {};
    loop.push_back(best);
    const Index end = other_end(layout.pieces[best], node);
    back = heading(layout.nodes[end], layout.nodes[node]);
    node = end;
    if (node == start) return loop;
  }
  return {};
}

// Rotates the loop so that it starts in corner 0.
std::vector<Index> from_corner(const Layout& layout, Index start, std::vector<Index> loop) {
  if (layout.corners.empty()) return {};
  Index node = start;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (node == layout.corners.front()) {
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i), loop.end());
      return loop;
    }
    node = other_end(layout.pieces[loop[i]], node);
  }
  return {};
}

// Coordinates rounded in a file bend straight sides a little: corners that turn by less than a
// hundredth of a radian are none.
void drop_straight(const std::vector<Vec3>& nodes, std::vector<Index>& hull) {
  constexpr double kStraight = 0.01;
  for (std::size_t i = 0, kept = 0; hull.size() >= 3 && kept < hull.size();) {
    const std::size_t count = hull.size();
    i %= count;
    const Vec3 &p = nodes[hull[(i + count - 1) % count]], &q = nodes[hull[i]],
               &r = nodes[hull[(i + 1) % count]];
    if (cross(p, q, r) < kStraight * (q - p).norm() * (r - q).norm()) {
      hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
      kept = 0;
    } else {
      ++i;
      ++kept;
    }
  }
}

// A lowest node in which pieces meet: it is on the outer face.
Index lowest(const Layout& layout, const Incidence& around) {
  Index best = kNone;
  for (Index i = 0; i < static_cast<Index>(layout.nodes.size()); ++i) {
    if (around.start[i] == around.start[i + 1]) continue;
    if (best == kNone) best = i;
    if (layout.nodes[i].y() < layout.nodes[best].y()) best = i;
  }
  return best;
}

}  // namespace

std::vector<Index> hull_corners(const std::vector<Vec3>& nodes) {
  std::vector<Index> order(nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index i, Index j) {
    const Vec3 &p = nodes[i], &q = nodes[j];
    if (p.x() != q.x()) return p.x() < q.x();
    return p.y() != q.y() ? p.y() < q.y() : i < j;
  });
  double size = 0.0;
  for (const Vec3& p : nodes) size = std::max(size, (p - nodes[order.front()]).norm());
  const double flat = 1e-12 * size * size;
  // Andrew's monotone chain: the lower boundary from left to right, then the upper one back.
  std::vector<Index> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = hull.size();
    for (const Index i : order) {
      while (hull.size() >= base + 2 &&
             cross(nodes[hull[hull.size() - 2]], nodes[hull.back()], nodes[i]) <= flat) {
        hull.pop_back();
      }
      hull.push_back(i);
    }
    hull.pop_back();
    std::reverse(order.begin(), order.end());
  }
  drop_straight(nodes, hull);
  if (hull.size() < 3 || doubled_area(nodes, hull) <= flat) return {};
  Vec3 mean = Vec3::Zero();
  for (const Index i : hull) mean += nodes[i] / double(hull.size());
  // A corner that a file's digits put a little below +x is still the first one.
  constexpr double kRounding = 1e-3;
  const auto angle = [&](Index i) { return turn_from(-kRounding, heading(mean, nodes[i])); };
  const auto first = std::min_element(hull.begin(), hull.end(),
                                      [&](Index i, Index j) { return angle(i) < angle(j); });
  std::rotate(hull.begin(), first, hull.end());
  return hull;
}

std::vector<Index> find_outline(const Layout& layout) {
  for (const bool border_only : {true, false}) {
    const Incidence around = incidence(layout, border_only);
    const Index start = lowest(layout, around);
    if (start == kNone) continue;
    std::vector<Index> loop = walk(layout, around, start);
    if (border_only && loop.size() * 2 != around.pieces.size()) continue;
    loop = from_corner(layout, start, std::move(loop));
    if (!loop.empty()) return loop;
  }
  return {};
}

double doubled_area(const std::vector<Vec3>& nodes, const std::vector<Index>& polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = nodes[polygon[i]], &q = nodes[polygon[(i + 1) % polygon.size()]];
    area += p.x() * q.y() - p.y() * q.x();
  }
  return area;
}

}  // namespace retiarius

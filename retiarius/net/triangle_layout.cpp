#include <cmath>
#include <numeric>
#include <utility>

#include "retiarius/net/layout.hpp"

namespace retiarius {
namespace {

// Knots lie in rows: row r has r + 1 of them and is r pieces away from corner 0; `place` counts
// from the side between corners 0 and 1.
Index knot(std::int64_t row, std::int64_t place) {
  return static_cast<Index>(row * (row + 1) / 2 + place);
}

void place_knots(Layout& layout, double side, std::int64_t n) {
  const double radius = side / std::sqrt(3.0);
  const Vec3 corner0(radius, 0.0, 0.0), corner1(-radius / 2.0, side / 2.0, 0.0),
      corner2(-radius / 2.0, -side / 2.0, 0.0);
  for (std::int64_t row = 0; row <= n; ++row) {
    for (std::int64_t place = 0; place <= row; ++place) {
      layout.nodes.push_back(
          (double(n - row) * corner0 + double(row - place) * corner1 + double(place) * corner2) /
          double(n));
    }
  }
}

void add_perimeter(Layout& layout, std::int64_t n, double length) {
  std::vector<Index> sides[3];
  for (std::int64_t t = 0; t <= n; ++t) {
    sides[0].push_back(knot(t, 0));
    sides[1].push_back(knot(n, t));
    sides[2].push_back(knot(n - t, n - t));
  }
  for (std::vector<Index>& nodes : sides) {
    layout.corners.push_back(nodes.front());
    add_line(layout, std::move(nodes), length, true);
  }
  layout.outline.resize(layout.pieces.size());
  std::iota(layout.outline.begin(), layout.outline.end(), 0);
}

}  // namespace

Layout triangle_layout(double side, std::int64_t n, bool diamond) {
  Layout layout;
  place_knots(layout, side, n);
  const double length = side / double(n);
  add_perimeter(layout, n, length);
  for (std::int64_t offset = 1; offset < n; ++offset) {
    std::vector<Index> along_first, along_last, across;
    for (std::int64_t row = offset; row <= n; ++row) {
      along_first.push_back(knot(row, offset));
      along_last.push_back(knot(row, row - offset));
    }
    for (std::int64_t place = 0; place <= offset; ++place) across.push_back(knot(offset, place));
    add_line(layout, std::move(along_first), length, false);
    add_line(layout, std::move(along_last), length, false);
    if (!diamond) add_line(layout, std::move(across), length, false);
  }
  return layout;
}

}  // namespace retiarius

#include <numeric>
#include <utility>

#include "retiarius/net/layout.hpp"

namespace retiarius {
namespace {

// The knots from (column, row) on, in steps of (right, up).
std::vector<Index> run(std::int64_t n, std::int64_t column, std::int64_t row, int right, int up) {
  std::vector<Index> nodes;
  for (std::int64_t t = 0; t <= n; ++t) {
    nodes.push_back(static_cast<Index>((row + up * t) * (n + 1) + column + right * t));
  }
  return nodes;
}

}  // namespace

Layout square_layout(double side, std::int64_t n) {
  Layout layout;
  const auto coordinate = [&](std::int64_t i) { return side * double(2 * i - n) / double(2 * n); };
  for (std::int64_t row = 0; row <= n; ++row) {
    for (std::int64_t column = 0; column <= n; ++column) {
      layout.nodes.emplace_back(coordinate(column), coordinate(row), 0.0);
    }
  }
  const double length = side / double(n);
  for (auto& nodes :
       {run(n, n, n, -1, 0), run(n, 0, n, 0, -1), run(n, 0, 0, 1, 0), run(n, n, 0, 0, 1)}) {
    layout.corners.push_back(nodes.front());
    add_line(layout, nodes, length, true);
  }
  layout.outline.resize(layout.pieces.size());
  std::iota(layout.outline.begin(), layout.outline.end(), 0);
  for (std::int64_t row = 1; row < n; ++row) add_line(layout, run(n, 0, row, 1, 0), length, false);
  for (std::int64_t col = 1; col < n; ++col) add_line(layout, run(n, col, 0, 0, 1), length, false);
  return layout;
}

}  // namespace retiarius

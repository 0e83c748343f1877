#include "retiarius/net/layout.hpp"

#include <algorithm>
#include <utility>

#include "retiarius/net/check_spec.hpp"
#include "retiarius/net/network_file.hpp"

namespace retiarius {
namespace {

constexpr double kCollinear = 0.999;

Vec3 direction(const Layout& layout, const Piece& piece) {
  return (layout.nodes[piece.b] - layout.nodes[piece.a]).normalized();
}

}  // namespace

void add_line(Layout& layout, std::vector<Index> nodes, double rest_length, bool border) {
  const auto first = static_cast<Index>(layout.pieces.size());
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    layout.pieces.push_back({nodes[i], nodes[i + 1], rest_length, border});
  }
  layout.lines.push_back({std::move(nodes), first, border});
}

std::vector<char> find_knots(const Layout& layout) {
  // An end counts as two passes, so that a node is a knot from two on.
  std::vector<char> passes(layout.nodes.size(), 0);
  const auto visit = [&](Index node, char weight) {
    passes[node] = static_cast<char>(std::min(2, passes[node] + weight));
  };
  for (const Line& line : layout.lines) {
    for (std::size_t i = 1; i + 1 < line.nodes.size(); ++i) visit(line.nodes[i], 1);
    if (line.closed()) {
      visit(line.nodes.front(), 1);
    } else {
      visit(line.nodes.front(), 2);
      visit(line.nodes.back(), 2);
    }
  }
  for (char& count : passes) count = count >= 2 ? 1 : 0;
  return passes;
}

bool keeps_joint(const Layout& layout, const std::vector<char>& is_knot, Knots knots, Index first,
                 Index second) {
  const Piece& one = layout.pieces[first];
  const Piece& two = layout.pieces[second];
  if (knots == Knots::hinged && is_knot[one.b]) return false;
  return direction(layout, one).dot(direction(layout, two)) > kCollinear;
}

Layout make_layout(const NetSpec& spec) {
  if (spec.pattern == Pattern::file) return read_network_file(spec.file);
  const std::int64_t n = pieces_per_side(spec);
  switch (spec.pattern) {
    case Pattern::square:
      // Lines at 45 degrees are parallel to the spokes: the four-sided polygon in sectors.
      if (spec.cell == Cell::diamond) return polygon_layout(4, spec.side, n, kPi / 4.0);
      return square_layout(spec.side, n);
    case Pattern::triangle:
      return triangle_layout(spec.side, n, spec.cell == Cell::diamond);
    case Pattern::polygon:
      return polygon_layout(spec.sides, spec.side, n, 0.0);
    default:
      return polygon_layout(6, spec.side, n, 0.0);
  }
}

}  // namespace retiarius

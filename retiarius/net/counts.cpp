#include "retiarius/net/counts.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/net/check_spec.hpp"
#include "retiarius/net/network_file.hpp"

namespace retiarius {
namespace {

struct PlanCounts {
  double nodes = 0, knots = 0, pieces = 0, corners = 0;
  double knot_joints = 0;  // of threads that run straight through knots
};

// Spokes, perimeter sides, and in each sector two families of lines of 1 to n - 1 pieces.
PlanCounts count_polygon(double sides, double n) {
  PlanCounts plan;
  plan.knots = 1 + sides * n * (n + 1) / 2;
  plan.pieces = sides * n * (n + 1);
  const bool even = static_cast<long long>(sides) % 2 == 0;
  plan.knot_joints = (even ? sides / 2 : 0) + 2 * sides * (n - 1) + sides * (n - 1) * (n - 2);
  // Only with four sides do sector lines run straight across the spokes.
  if (sides == 4) plan.knot_joints += sides * (n - 1);
  plan.corners = sides;
  return plan;
}

PlanCounts count_square(double n) {
  return {0, (n + 1) * (n + 1), 2 * n * (n + 1), 4, 2 * (n + 1) * (n - 1)};
}

PlanCounts count_triangle(double n, bool diamond) {
  PlanCounts plan;
  plan.knots = (n + 1) * (n + 2) / 2;
  plan.pieces = diamond ? n * n + 2 * n : 3 * n * (n + 1) / 2;
  plan.knot_joints = diamond ? n * n - 1 : 3 * n * (n - 1) / 2;
  plan.corners = 3;
  return plan;
}

PlanCounts count_pattern(const NetSpec& spec) {
  const auto n = static_cast<double>(pieces_per_side(spec));
  switch (spec.pattern) {
    case Pattern::square:
      return spec.cell == Cell::diamond ? count_polygon(4, n) : count_square(n);
    case Pattern::triangle:
      return count_triangle(n, spec.cell == Cell::diamond);
    case Pattern::polygon:
      return count_polygon(spec.sides, n);
    default:
      return count_polygon(6, n);
  }
}

NetworkCounts finish(const PlanCounts& plan, const NetSpec& spec) {
  const double inner = spec.segments - 1;
  const double bridle = spec.corner_mass.bridle > 0.0 ? spec.corner_mass.bridle_segments : 0.0;
  NetworkCounts counts;
  counts.knots = plan.knots;
  counts.nodes = plan.nodes + inner * plan.pieces + bridle * plan.corners;
  counts.segments = spec.segments * plan.pieces + bridle * plan.corners;
  counts.joints = inner * plan.pieces + plan.knot_joints + std::max(0.0, bridle - 1) * plan.corners;
  return counts;
}

}  // namespace

NetworkCounts count_layout(const Layout& layout, const NetSpec& spec) {
  const std::vector<char> is_knot = find_knots(layout);
  PlanCounts plan;
  plan.nodes = static_cast<double>(layout.nodes.size());
  plan.knots = static_cast<double>(std::count(is_knot.begin(), is_knot.end(), 1));
  plan.pieces = static_cast<double>(layout.pieces.size());
  plan.corners = static_cast<double>(layout.corners.size());
  for (const Line& line : layout.lines) {
    const Index first = line.first_piece, last = first + line.piece_count() - 1;
    for (Index p = first; p < last; ++p) {
      plan.knot_joints += keeps_joint(layout, is_knot, spec.knots, p, p + 1);
    }
    if (line.closed()) {
      plan.knot_joints += keeps_joint(layout, is_knot, spec.knots, last, first);
    }
  }
  return finish(plan, spec);
}

void check_counts(const NetworkCounts& counts, const NetSpec& spec) {
  const double most = std::numeric_limits<Index>::max();
  const double largest = std::max({counts.nodes, counts.segments, counts.joints});
  if (largest <= most) return;
  const std::string cause =
      spec.pattern == Pattern::file
          ? fmt::format("net.segments = {}", spec.segments)
          : fmt::format("net.mesh = {:.12g} with net.segments = {}", spec.mesh, spec.segments);
  throw InputError(fmt::format(
      "{}: gives {:.3g} nodes and {:.3g} segments, more than the {} that can be numbered; choose "
      "a coarser mesh or fewer segments",
      cause, counts.nodes, counts.segments, most));
}

NetworkCounts count_network(const NetSpec& spec) {
  check_spec(spec);
  if (spec.pattern == Pattern::file) return count_layout(read_network_file(spec.file), spec);
  PlanCounts plan = count_pattern(spec);
  plan.nodes = plan.knots;
  if (spec.knots == Knots::hinged) plan.knot_joints = 0;
  return finish(plan, spec);
}

}  // namespace retiarius

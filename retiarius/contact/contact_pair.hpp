// Pairs of primitives that may touch.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

#include "retiarius/base/vec.hpp"

namespace retiarius {

enum class PairKind : std::uint8_t {
  point_point,
  point_edge,
  point_triangle,
  edge_edge,
  point_plane
};

// The owner of a primitive: a body's index, or this.
inline constexpr Index kNet = kNone;

// The first primitive is a point, or an edge in edge_edge; the second what the kind says. The net
// comes first in edge_edge with a body; two edges of the net, or of bodies, stand in ascending
// order of (owner, edge).
struct ContactPair {
  PairKind kind = PairKind::point_point;
  Index first_owner = kNet, first = kNone;
  Index second_owner = kNet, second = kNone;  // of a plane `second` is 0

  auto operator<=>(const ContactPair&) const = default;  // NOLINT(modernize-use-nullptr)
};

inline bool is_of_threads(const ContactPair& pair) {
  return pair.first_owner == kNet && pair.second_owner == kNet;
}

// How many points a pair has, and how many of them are of the first primitive.
inline constexpr int point_count(PairKind kind) {
  constexpr int kCount[] = {2, 3, 4, 4, 1};
  return kCount[static_cast<int>(kind)];
}
inline constexpr int first_count(PairKind kind) { return kind == PairKind::edge_edge ? 2 : 1; }

// The positions of a pair's points: those of the first primitive, then those of the second. Of
// point_plane: the point, a place of the plane, and that place plus the plane's unit normal.
using PairPositions = std::array<Vec3, 4>;

}  // namespace retiarius

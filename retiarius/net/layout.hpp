// The plan of a net before its pieces are cut into segments: knots, pieces, lines of pieces.
#pragma once

#include <cstdint>
#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/net/spec.hpp"

namespace retiarius {

struct Piece {
  Index a = kNone, b = kNone;  // its nodes, in the direction of its line
  double rest_length = 0.0;    // m
  bool border = false;         // made of the border's material
};

// A thread as planned. Its pieces are numbered consecutively from `first_piece`; a closed line
// repeats its first node at the end.
struct Line {
  std::vector<Index> nodes;
  Index first_piece = 0;
  bool border = false;

  Index piece_count() const { return static_cast<Index>(nodes.size()) - 1; }
  bool closed() const { return nodes.size() > 2 && nodes.front() == nodes.back(); }
};

struct Layout {
  std::vector<Vec3> nodes;        // m, centre at the origin
  std::vector<double> node_mass;  // kg, in addition to thread and knot mass; empty: none
  std::vector<Piece> pieces;
  std::vector<Line> lines;
  std::vector<Index> corners;  // the mouth, counter-clockwise
  std::vector<Index> outline;  // the perimeter's pieces, counter-clockwise from corner 0; or empty
};

// Appends a line through `nodes` whose pieces all have one rest length.
void add_line(Layout& layout, std::vector<Index> nodes, double rest_length, bool border);

// For each node whether it is a knot: threads cross or end in it.
std::vector<char> find_knots(const Layout& layout);

// Whether the line that passes from piece `first` to piece `second` keeps a joint in the node
// between them: the pieces are collinear (t1.t2 > 0.999), and the node is no knot or knots are
// continuous.
bool keeps_joint(const Layout& layout, const std::vector<char>& is_knot, Knots knots, Index first,
                 Index second);

// The layout of a spec that check_spec accepts. Throws InputError for a wrong network file.
Layout make_layout(const NetSpec& spec);

// The patterns, each with n = side / mesh pieces along a side.
//
// Regular polygon in sectors: each sector between two spokes carries the lines parallel to these
// spokes, through the points that divide the spokes into n pieces; the only lines parallel to the
// outer side are the perimeter. Perimeter pieces have length side / n, all others R / n with the
// circumradius R = side / (2 sin(pi / sides)); both equal the mesh for the hexagon only. Opposite
// spokes of an even number of sides are one thread through the centre. Corner k lies at the angle
// turn + 2 pi k / sides from +x.
Layout polygon_layout(int sides, double side, std::int64_t n, double turn);

// Square cells along the sides, which lie along the axes; corner 0 is (+,+).
Layout square_layout(double side, std::int64_t n);

// Equilateral triangle, corner 0 on +x. Threads parallel to all three sides, or (diamond) only to
// the two sides that meet in corner 0, closed by the third side; all pieces have length side / n.
Layout triangle_layout(double side, std::int64_t n, bool diamond);

}  // namespace retiarius

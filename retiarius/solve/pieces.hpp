// The inner nodes of a net's pieces: small paths in a matrix's graph that can be eliminated each by
// itself, many at once.
#pragma once

#include <vector>

#include "retiarius/solve/ordering.hpp"

namespace retiarius {

struct EliminatedPiece {
  std::vector<Index> columns;  // in the order of elimination: along the path
  std::vector<Index> border;   // what they are coupled to besides, as met along the path
};

// Vertices of few neighbours form paths; where paths of two pieces are coupled across a knot (by
// bending), one vertex there is left out. The bound on neighbours that lets most vertices go is
// taken. No two pieces share a column or are coupled but by their borders. Deterministic.
std::vector<EliminatedPiece> find_pieces(const Graph& graph);

}  // namespace retiarius

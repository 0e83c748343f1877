// Pieces of one shape side by side: everything about their elimination that follows from the
// pattern alone.
#pragma once

#include <map>
#include <vector>

#include "retiarius/solve/piece_kernels.hpp"
#include "retiarius/solve/pieces.hpp"

namespace retiarius {

// The elimination of a piece, in its own numbers (see kernels::PiecePlan).
struct PieceShape {
  Index columns = 0, border = 0;
  std::vector<int> at, starts, rows, targets, places;
  std::vector<char> whole;
  std::vector<std::pair<Index, Index>> blocks;  // of the matrix, row and column
  std::vector<int> border_at;                   // of each pair p >= q of the border, row by row
  int size = 0;

  kernels::PiecePlan plan() const;
};

// At most kPieceLanes pieces of one shape.
struct PieceBatch {
  Index shape = 0;
  int lanes = 0;
  std::size_t sources = 0;  // in PieceBatches::sources
  std::size_t nodes = 0;    // in PieceBatches::nodes
  std::size_t slots = 0;    // in PieceBatches::border_slots
  std::size_t values = 0;   // of the factor, in doubles
  std::size_t vector = 0;   // of the right-hand sides, in doubles
};

struct PieceBatches {
  std::vector<PieceShape> shapes;
  std::vector<PieceBatch> batches;
  std::vector<int> sources;         // of each block and lane
  std::vector<Index> nodes;         // of each block of a piece and lane; kNone in idle lanes
  std::vector<Index> border_slots;  // of each pair p >= q of the border and lane in the rest's
                                    // matrix: its diagonal block, or ~slot if it comes transposed
  std::size_t values_size = 0, vector_size = 0;

  std::vector<Index> kept;            // blocks that are not eliminated, ascending
  std::vector<Index> place;           // of each block among them, or kNone
  BlockPattern rest;                  // the pattern of what is left
  std::vector<Index> kept_slots;      // of each pair of `rest` in the pattern, or kNone
  double entries = 0.0, flops = 0.0;  // of the elimination
  Index columns = 0;                  // blocks eliminated
};

// Pieces that share their shape with fewer than kPieceLanes / 2 others are left in the rest.
PieceBatches make_batches(const BlockPattern& pattern, const Graph& graph,
                          const std::vector<EliminatedPiece>& pieces);

}  // namespace retiarius

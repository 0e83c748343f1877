// Elimination of many equal pieces of a matrix at once, a piece a lane, as a table of functions:
// one table for each instruction set. Plain types only: the units behind it are compiled for
// different processors.
#pragma once

namespace retiarius::kernels {

// Pieces side by side. Every number of a piece is a row of so many doubles in memory.
inline constexpr int kPieceLanes = 8;

// Blocks below a column's diagonal, at most.
inline constexpr int kMostPieceRows = 8;

// What pieces of one shape have in common. Blocks of a piece are numbered: first the `columns` that
// are eliminated, in that order, then the `border` that stays. Numbers are counted in rows of
// lanes. A column holds six numbers of its diagonal block (xx, yx, zx, yy, zy, zz) and nine of each
// block below, column by column; behind the columns lies the border's own lower triangle.
struct PiecePlan {
  int columns, border;
  const int* at;      // where each column begins
  const int* starts;  // of each column in `rows`, and the end
  const int* rows;    // the numbers of the blocks below each column, ascending
  const int*
      targets;        // for each column and each pair i >= j of its rows: the block that it changes
  int blocks;         // of the matrix that a piece has
  const int* places;  // where each of them goes
  const char* whole;  // whether it takes nine numbers; else a diagonal's six
  int size;           // numbers of a piece in all
};

struct PieceTable {
  // Puts the matrix's blocks of kPieceLanes pieces into `values`. sources: of each block and lane,
  // its number among the diagonal or other blocks; ~number where it comes transposed. Lanes from
  // `lanes` on become the identity.
  void (*gather)(const PiecePlan& plan, const int* sources, int lanes, const double* diagonal,
                 const double* below, double* values);

  // A = L D L^T of the columns, in place; on return the border's triangle holds what to add to the
  // matrix there. False when a pivot is not positive and finite.
  bool (*factor)(const PiecePlan& plan, double* values);

  // y = L^-1 x for right-hand sides of three numbers a block. On entry the border is zero; on
  // return it holds what to add there.
  void (*forward)(const PiecePlan& plan, const double* values, double* x);

  // x = L^-T D^-1 y, with the border's solution in its place.
  void (*backward)(const PiecePlan& plan, const double* values, double* x);
};

// The table of the instruction set in use.
const PieceTable& pieces();

}  // namespace retiarius::kernels

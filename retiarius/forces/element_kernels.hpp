// The laws' elements in vectors, one element a lane, as a table of functions: one table for each
// instruction set. Plain types only: the units behind it are compiled for different processors.
#pragma once

namespace retiarius::kernels {

// Arrays of elements are padded by so many that whole vectors can be read from any element on.
inline constexpr int kElementPadding = 8;

// Where a law adds what it computes; 3 doubles a node, 9 a block, column by column. Null: not
// wanted; without gradient no Hessian either.
struct ElementSums {
  double* gradient;
  double* diagonal;
  double* below;
};

// Segments a-b with tension c eps - d.
struct SegmentArrays {
  const int* a;
  const int* b;
  const int* slot;          // of the pair's block
  const double* rest;       // l0, m
  const double* stiffness;  // c, N
  const double* offset;     // d, N
  const double* foretold;   // tension for the Hessian's part across, N; negative: as it is
  const double* bilateral;  // 1: carries compression; 0: tension only
};

// Joints a-b-c.
struct JointArrays {
  const int* a;
  const int* b;
  const int* c;
  const int* ab;  // slots of the pairs' blocks; ~slot where the first node is the block's column
  const int* ac;
  const int* bc;
  const double* rest1;   // m
  const double* rest2;   // m
  const double* factor;  // EI / (2 lv), J
};

// All functions treat elements [begin, end) at positions y, add to `sums`, and return the
// potential, J.
struct ElementTable {
  // `definite`: blocks projected to be positive semidefinite.
  double (*stretching)(const SegmentArrays& segments, long begin, long end, const double* y,
                       bool definite, const ElementSums& sums);
  double (*bounded_bending)(const JointArrays& joints, long begin, long end, const double* y,
                            const ElementSums& sums);
  double (*tangent_bending)(const JointArrays& joints, long begin, long end, const double* y,
                            const ElementSums& sums);
};

// The table of the instruction set in use.
const ElementTable& elements();

}  // namespace retiarius::kernels

// The dense kernels of the multifrontal solver as a table of functions, one for each instruction
// set. Plain types only: the units behind it are compiled for different processors.
#pragma once

namespace retiarius::kernels {

// Rows of panels and updates are padded to a multiple of this, the widest vector in doubles.
inline constexpr int kPadding = 8;

// So many right-hand sides are solved at once. They lie interleaved: row by row, kLanes to a row.
inline constexpr int kLanes = 8;

// Consecutive rows of a child's update that are consecutive in its parent's front, in scalars.
struct Run {
  int from, to, length;
};

// Adds a child's update matrix (lower triangle) into its parent's front.
struct Extension {
  const double* child;
  long child_ld;
  int begin, end;      // block columns of the child's update to add
  const int* columns;  // for each, its block position in the parent's front
  const Run* runs;     // `to` counts rows of the parent's panel
  int run_count;
  double* panel;  // of the parent
  long panel_ld;
  int pivots;      // block columns of the panel
  int pivot_rows;  // rows of the panel above the first row of the update, padding included
  double* update;  // of the parent
  long update_ld;
};

// One front's part in forward substitution for kLanes right-hand sides.
struct Sweep {
  const double* panel;
  long ld;
  int pivots;
  int pivot_rows;   // rows of the panel above the first row below the pivots, padding included
  const int* rows;  // numbers of the blocks below
  int below;        // how many
  double* own;      // the front's pivot rows in `all`
  double* all;      // right-hand sides and solutions in the order of elimination
};

struct KernelTable {
  // Cholesky factorisation of the panel's k pivot columns, in place; the diagonal is left as its
  // reciprocals. False when a pivot is not positive and finite.
  bool (*factor_panel)(double* panel, int ld, int k);

  // Rows [row_begin, row_end) of update = -below below^T, lower triangle in tiles: at least from
  // the first row of each 3x3 diagonal block on. `below` is the panel's first row under the pivots.
  void (*update)(const double* below, int ld, int k, double* update, int update_ld, int u,
                 int row_begin, int row_end);

  void (*extend_add)(const Extension& extension);

  // x = L11^-1 w and w -= L x. On entry w holds the right-hand side in the pivot rows and zero
  // elsewhere; on return its rows below the pivots hold what to add to the right-hand side there.
  void (*forward)(const double* panel, int ld, int k, double* w, double* x);

  // x = L11^-T (x - L21^T w). On entry w holds zero in the pivot rows and the solution below.
  void (*backward)(const double* panel, int ld, int k, double* w, double* x);

  // Forward for kLanes right-hand sides, in place: own = L11^-1 own, then L21 own is subtracted
  // from the rows below. Lanes do not mix.
  void (*forward_lanes)(const Sweep& sweep);

  // Adds to sums[kLanes i + j] the sum over all rows of a's lane i times b's lane j. All three
  // stand on cache lines.
  void (*products)(const double* a, const double* b, long rows, double* sums);
};

// The table chosen by set_kernels().
const KernelTable& active();

}  // namespace retiarius::kernels

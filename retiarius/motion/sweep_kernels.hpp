// Sub-steps of the explicit integrator in vectors, as a table of functions: one table for each
// instruction set. Plain types only: the units behind it are compiled for different processors.
#pragma once

namespace retiarius::kernels {

// Chains that are swept side by side.
inline constexpr int kSweepLanes = 8;

// Several chains of segments side by side, one a lane. Row j holds the chains' nodes number j;
// segment row j lies between node rows j and j + 1.
struct SweepGroup {
  long rows;                // of nodes
  const int* place;         // of each row: where its 3 x 8 coordinates begin, or -1: shared nodes
  const int* shared;        // 8 for each row of shared nodes: where the lanes' nodes begin
  double* ends;             // 32 for each such row: force of the chain on each, N
  long step;                // 8, or 0 where all rows share one of each of the next three
  const double* inverse;    // 8 for each row that is not of shared nodes: 1/kg
  const double* rest;       // 8 for each segment row: l0, m
  const double* stiffness;  // k = EA / l0, N/m; 0 where the lane has no such segment
  double* elongation[2];    // at the last evaluations, taut part where tension-only, m
  double* drag;             // viscous tension at the last evaluation, N
  double* tension;          // 8 for each segment row, N, where recorded
  double viscosity;         // tau / h
  bool bilateral;
};

// Shared nodes [begin, end) that as many chains meet in.
struct SweepRun {
  int begin, end;
  int count;
  const int* ends;  // `count` for each node: where the forces begin in the array of ends
};

// A node has its coordinates in one array of positions and one of velocities: a shared node at
// 4 i with stride 1 and a zero behind; the others in rows of 3 x 8, with stride 8.
struct SweepState {
  double* x;                     // m
  double* v;                     // m/s
  const double* force;           // of further laws, N, placed as x; or null
  const double* inverse_shared;  // 1/kg, of each shared node
  const double* ends;
  // v becomes keep v + gain (force / m + g), x grows by drift v.
  double keep, gain, drift;
  // Which elongations are of the last evaluation; the others, of the one before, are replaced.
  int last;
  double g[3];
};

// Planes that stand for surfaces near nodes, in blocks of eight; vectors are stored as 3 x 8. Lanes
// that are not needed have no bounds.
struct SweepPlanes {
  long blocks;
  const int* place;      // of each block: where its row begins, or -1: shared nodes
  const int* shared;     // 8 for each such block: where the nodes begin
  const double* origin;  // m
  const double* normal;
  const double* offset;  // gap at the origin, m
  const double* reach;   // squared distance from the origin within which the plane serves, m2
  const double* far;     // gap beyond which the node need not be watched, m
  double* gap;           // m
  double* velocity;      // m/s
};

struct SweepTable {
  // Forces of all groups, and the motion of the nodes that lie in rows. Returns the work of viscous
  // tension since the last evaluation, by the trapezoidal rule, J. `record`: writes tensions.
  // fastest: raised to the size of the nodes' largest velocity component, m/s.
  double (*sweep)(const SweepGroup* groups, long count, const SweepState& state, bool record,
                  double* fastest);
  // The motion of the shared nodes, from the forces at the chains' ends.
  void (*move_shared)(const SweepRun* runs, long count, const SweepState& state, double* fastest);
  // The eighths k of the arrays (doubles 8 k to 8 k + 7) where |x - origin| exceeds the limit
  // somewhere; returns their number. size: a multiple of 8. slack: lowered to the smallest limit
  // - |x - origin| elsewhere.
  long (*outside)(const double* x, const double* origin, const double* limit, long size, int* found,
                  double* slack);
  // Gap and velocity of the nodes that are clear of their planes. The others, into a plane or
  // beyond its reach, stay as they were and go to `found`; returns their number. far: set where a
  // node that is clear is beyond its own.
  long (*clear)(const SweepPlanes& planes, const double* x, const double* v, int* found, bool* far);
};

// The table of the instruction set in use.
const SweepTable& sweeps();

}  // namespace retiarius::kernels

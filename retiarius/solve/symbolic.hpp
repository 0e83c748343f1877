// Everything about a multifrontal factorisation that follows from the pattern alone: the order, the
// fronts, and where every number goes.
#pragma once

#include <cstddef>
#include <vector>

#include "retiarius/solve/kernel_table.hpp"
#include "retiarius/solve/supernodes.hpp"

namespace retiarius {

// Copies one block of the matrix to an offset in a front's panel.
struct BlockCopy {
  Index slot;
  Index offset;
};

// A dense front: `columns` pivot blocks and `below` blocks of rows under them. Its panel is the
// part of the factor it yields, its update what it passes on to its parent.
struct Front {
  Index parent = kNone;
  Index first = 0;  // first pivot block, in the order of elimination
  Index columns = 0, below = 0;
  Index task = kNone;                          // the subtree it belongs to; kNone near the root
  std::size_t child_begin = 0, child_end = 0;  // in Symbolic::children
  std::size_t rows = 0;                        // in Symbolic::rows and ::targets
  Index into_panel = 0;                        // so many of `below` are pivots of the parent
  std::size_t run_begin = 0, run_end = 0;      // in Symbolic::runs
  std::size_t straight = 0, transposed = 0, copies_end = 0;  // in Symbolic::copies
  std::size_t panel = 0;                                     // in the factor, in scalars
  std::size_t update = 0;       // in the memory of a factorisation by one thread
  std::size_t task_update = 0;  // by several: in the memory of its task, or in the shared memory
  bool update_shared = false;   // outlives its task
  int ld = 0, pivot_rows = 0, update_ld = 0;

  int pivots() const { return 3 * columns; }
  int rows_below() const { return 3 * below; }
};

// A subtree that one thread works through from begin to end.
struct FrontTask {
  Index begin = 0, end = 0;
  std::size_t memory = 0;  // scalars for the updates within
  std::size_t offset = 0;  // of its memory in that of all tasks
};

struct Symbolic {
  std::vector<Index> order;     // order[k] = block eliminated as number k
  std::vector<Front> fronts;    // in postorder
  std::vector<Index> children;  // of all fronts
  std::vector<Index> rows;      // numbers of the blocks below, ascending within a front
  std::vector<int> targets;     // for each of `rows`, its block position in the parent's front
  std::vector<kernels::Run> runs;
  std::vector<BlockCopy> copies;
  std::vector<FrontTask> tasks;
  std::vector<Index> top;       // fronts outside every task, in postorder
  std::size_t factor_size = 0;  // scalars, padding included
  std::size_t update_size = 0;  // scalars for updates with one thread
  std::size_t shared_size = 0;  // with several: for updates that outlive their task
  std::size_t tasks_size = 0;   // and for those within tasks, all together
  int largest_ld = 0;
  double entries = 0.0, flops = 0.0;  // of the factor without explicit zeros
  double cost = 0.0;                  // see Supernodes
};

// Analyses a finished pattern under the best of several orders, `trials` of them by nested
// dissection (their work differs by a few per cent). Deterministic.
inline constexpr int kOrderTrials = 3;
Symbolic analyse_fronts(const BlockPattern& pattern, int trials = kOrderTrials);

// The same for a given order of elimination.
Symbolic analyse_fronts(const BlockPattern& pattern, const std::vector<Index>& order);

}  // namespace retiarius

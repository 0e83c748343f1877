// Groups of columns that a factorisation treats as one dense front.
#pragma once

#include <vector>

#include "retiarius/solve/elimination_tree.hpp"

namespace retiarius {

// Supernode s has the columns starts[s] .. starts[s + 1] of `order` and `below[s]` blocks of rows
// below them. Supernodes are in postorder of their own tree.
struct Supernodes {
  std::vector<Index> order;
  std::vector<Index> starts;
  std::vector<Index> parent;
  std::vector<Index> below;
  double cost = 0.0;  // estimated time of a factorisation, ns

  Index size() const { return static_cast<Index>(parent.size()); }
};

// Estimated time in ns of assembling and factoring one front of `columns` block columns and
// `below` block rows under them, and of adding its update to the parent.
double front_cost(Index columns, Index below);

// Columns with the same structure are joined; then children are merged into their parents, with
// explicit zeros, wherever that lowers the estimated time.
Supernodes supernodes(const EliminationTree& tree);

}  // namespace retiarius

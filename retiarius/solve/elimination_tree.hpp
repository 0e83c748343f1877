// The elimination tree of a symmetric matrix (J. W. H. Liu, The role of elimination trees in sparse
// factorization, SIAM J. Matrix Anal. Appl. 11, 1990) and the counts of its factor's columns.
#pragma once

#include <vector>

#include "retiarius/solve/ordering.hpp"

namespace retiarius {

struct EliminationTree {
  std::vector<Index> order;   // order[k] = vertex eliminated as number k; a postorder of the tree
  std::vector<Index> parent;  // of number k, always larger than k; kNone at a root
  std::vector<Index> counts;  // blocks in column k of the factor, with the diagonal
};

// Renumbers an order of elimination to a postorder, which leaves the fill as it is.
EliminationTree elimination_tree(const Graph& graph, const std::vector<Index>& order);

// Postorder of a forest given by parents; children are visited in ascending order of `weight`,
// ties by number. Returns the vertices in the order in which they are finished.
std::vector<Index> postorder(const std::vector<Index>& parent, const std::vector<double>& weight);

}  // namespace retiarius

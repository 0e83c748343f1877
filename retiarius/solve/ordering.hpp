// Orders of elimination that keep a factor sparse.
#pragma once

#include <vector>

#include "retiarius/base/block_matrix.hpp"

namespace retiarius {

// An undirected graph without loops; every edge is stored at both ends, neighbours ascending.
struct Graph {
  std::vector<Index> starts, neighbours;
  Index size() const { return static_cast<Index>(starts.size()) - 1; }
};

Graph block_graph(const BlockPattern& pattern);

// Both return order[k] = vertex eliminated as number k, and are deterministic.

// Nested dissection by METIS; vertices without neighbours come first. Different seeds give
// different orders of similar quality. Throws Error if METIS fails.
std::vector<Index> nested_dissection(const Graph& graph, int seed);

// Approximate minimum degree: good for small or tree-like graphs.
std::vector<Index> minimum_degree(const Graph& graph);

}  // namespace retiarius

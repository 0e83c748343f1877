#include "retiarius/solve/ordering.hpp"

#include <algorithm>
#include <csignal>
#include <mutex>
#include <numeric>

#include <Eigen/OrderingMethods>
#include <fmt/format.h>
#include <metis.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

// The subgraph of vertices that have neighbours, in the integer type of METIS.
struct MetisGraph {
  std::vector<idx_t> starts{0}, neighbours;
  std::vector<Index> vertices;  // of the whole graph

  explicit MetisGraph(const Graph& graph) {
    std::vector<idx_t> number(static_cast<std::size_t>(graph.size()), -1);
    for (Index v = 0; v < graph.size(); ++v) {
      if (graph.starts[v + 1] == graph.starts[v]) continue;
      number[v] = static_cast<idx_t>(vertices.size());
      vertices.push_back(v);
    }
    neighbours.reserve(graph.neighbours.size());
    for (const Index v : vertices) {
      for (Index k = graph.starts[v]; k < graph.starts[v + 1]; ++k) {
        neighbours.push_back(number[graph.neighbours[k]]);
      }
      starts.push_back(static_cast<idx_t>(neighbours.size()));
    }
  }
};

// METIS takes SIGTERM and SIGABRT over while it orders, ends with an error where SIGTERM comes, and
// gives handlers back that serve once only. In a process of several threads it may even jump from
// one thread into another. Here SIGTERM waits until METIS is done, and handlers are as before. The
// signal may still reach other threads, whose owner blocks it there.
class SignalsKept {
 public:
  SignalsKept() {
    sigset_t termination;
    sigemptyset(&termination);
    sigaddset(&termination, SIGTERM);
    ::pthread_sigmask(SIG_BLOCK, &termination, &mask_);
    ::sigaction(SIGTERM, nullptr, &on_termination_);
    ::sigaction(SIGABRT, nullptr, &on_abort_);
  }
  ~SignalsKept() {
    ::sigaction(SIGTERM, &on_termination_, nullptr);
    ::sigaction(SIGABRT, &on_abort_, nullptr);
    ::pthread_sigmask(SIG_SETMASK, &mask_, nullptr);
  }
  SignalsKept(const SignalsKept&) = delete;
  SignalsKept& operator=(const SignalsKept&) = delete;

 private:
  sigset_t mask_{};
  struct sigaction on_termination_ {
  }, on_abort_{};
};

}  // namespace

Graph block_graph(const BlockPattern& pattern) {
  const std::vector<Index>& starts = pattern.starts();
  const std::vector<Index>& rows = pattern.rows();
  Graph graph;
  graph.starts.assign(static_cast<std::size_t>(pattern.blocks()) + 1, 0);
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index k = starts[c]; k < starts[c + 1]; ++k) {
      ++graph.starts[c + 1];
      ++graph.starts[rows[k] + 1];
    }
  }
  std::partial_sum(graph.starts.begin(), graph.starts.end(), graph.starts.begin());
  graph.neighbours.resize(static_cast<std::size_t>(graph.starts.back()));
  std::vector<Index> next(graph.starts.begin(), graph.starts.end() - 1);
  // Smaller neighbours of a vertex come from earlier columns, so both passes fill in order.
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index k = starts[c]; k < starts[c + 1]; ++k) graph.neighbours[next[rows[k]]++] = c;
  }
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index k = starts[c]; k < starts[c + 1]; ++k) graph.neighbours[next[c]++] = rows[k];
  }
  return graph;
}

std::vector<Index> nested_dissection(const Graph& graph, int seed) {
  std::vector<Index> order;
  for (Index v = 0; v < graph.size(); ++v) {
    if (graph.starts[v + 1] == graph.starts[v]) order.push_back(v);
  }
  MetisGraph part(graph);
  auto count = static_cast<idx_t>(part.vertices.size());
  if (count <= 3) {
    order.insert(order.end(), part.vertices.begin(), part.vertices.end());
    return order;
  }
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = seed;
  options[METIS_OPTION_NUMBERING] = 0;
  options[METIS_OPTION_UFACTOR] = 400;  // uneven halves, 1.4 : 1, where the separator is smaller
  std::vector<idx_t> permutation(part.vertices.size()), inverse(part.vertices.size());
  // METIS draws from the C library's random numbers, which threads share: two orderings at once
  // would disturb each other, and no result would repeat.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const SignalsKept kept;
  const int status = METIS_NodeND(&count, part.starts.data(), part.neighbours.data(), nullptr,
                                  options, permutation.data(), inverse.data());
  if (status != METIS_OK) {
    throw Error(
        fmt::format("METIS could not order a graph of {} vertices (status {})", count, status));
  }
  for (const idx_t v : permutation) order.push_back(part.vertices[v]);
  return order;
}

std::vector<Index> minimum_degree(const Graph& graph) {
  std::vector<Eigen::Triplet<double, Index>> entries;
  for (Index v = 0; v < graph.size(); ++v) {
    entries.emplace_back(v, v, 1.0);
    for (Index k = graph.starts[v]; k < graph.starts[v + 1]; ++k) {
      entries.emplace_back(graph.neighbours[k], v, 1.0);
    }
  }
  Eigen::SparseMatrix<double> matrix(graph.size(), graph.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index> permutation;
  Eigen::AMDOrdering<Index>()(matrix, permutation);
  const auto& indices = permutation.indices();
  return {indices.data(), indices.data() + indices.size()};
}

}  // namespace retiarius

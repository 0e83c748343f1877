#include "retiarius/solve/elimination_tree.hpp"

#include <numeric>
#include <random>
#include <set>

#include <gmock/gmock.h>

#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

using testing::ElementsAre;

// Columns of the factor by elimination of one vertex after the other.
std::vector<std::set<Index>> eliminate(const Graph& graph, const std::vector<Index>& order) {
  std::vector<Index> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<Index>(k);
  std::vector<std::set<Index>> columns(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Index v = order[k];
    for (Index e = graph.starts[v]; e < graph.starts[v + 1]; ++e) {
      const Index other = position[graph.neighbours[e]];
      if (other > static_cast<Index>(k)) columns[k].insert(other);
    }
  }
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (const Index a : columns[k]) {
      for (const Index b : columns[k]) {
        if (b > a) columns[a].insert(b);
      }
    }
  }
  return columns;
}

TEST(EliminationTree, MatchesEliminationByHand) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    if (pattern.blocks() > 500) continue;
    const Graph graph = block_graph(pattern);
    std::vector<Index> order(static_cast<std::size_t>(graph.size()));
    std::iota(order.begin(), order.end(), 0);
    std::mt19937 generator(3);
    for (int repeat = 0; repeat < 3; ++repeat) {
      std::shuffle(order.begin(), order.end(), generator);
      const EliminationTree tree = elimination_tree(graph, order);
      const std::vector<std::set<Index>> columns = eliminate(graph, tree.order);
      for (Index k = 0; k < graph.size(); ++k) {
        ASSERT_EQ(tree.counts[k], static_cast<Index>(columns[k].size()) + 1) << name;
        ASSERT_EQ(tree.parent[k], columns[k].empty() ? kNone : *columns[k].begin()) << name;
      }
      // A postorder changes nothing about the fill.
      Index before = 0, after = 0;
      for (const auto& column : eliminate(graph, order))
        before += static_cast<Index>(column.size());
      for (const auto& column : columns) after += static_cast<Index>(column.size());
      EXPECT_EQ(before, after) << name;
    }
  }
}

TEST(EliminationTree, PostorderFinishesSubtreesLightestFirst) {
  //      4        5
  //    1   3
  //       0 2
  EXPECT_THAT(postorder({3, 4, 3, 4, kNone, kNone}, {2, 0, 1, 5, 0, 1}),
              ElementsAre(1, 2, 0, 3, 4, 5));
}

}  // namespace
}  // namespace retiarius

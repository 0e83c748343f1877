#include "retiarius/solve/ordering.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>

#include "retiarius/solve/elimination_tree.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

using testing::ElementsAre;

bool is_permutation(std::vector<Index> order, Index size) {
  std::sort(order.begin(), order.end());
  for (Index k = 0; k < static_cast<Index>(order.size()); ++k) {
    if (order[k] != k) return false;
  }
  return static_cast<Index>(order.size()) == size;
}

TEST(Ordering, GraphHasEveryPairAtBothEnds) {
  const Graph graph = block_graph(test::pattern_of(4, {{2, 0}, {0, 3}, {3, 2}}));
  EXPECT_THAT(graph.starts, ElementsAre(0, 2, 2, 4, 6));
  EXPECT_THAT(graph.neighbours, ElementsAre(2, 3, 0, 3, 0, 2));
}

TEST(Ordering, BothGivePermutations) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    const Graph graph = block_graph(pattern);
    EXPECT_TRUE(is_permutation(minimum_degree(graph), graph.size())) << name;
    for (const int seed : {1, 2}) {
      EXPECT_TRUE(is_permutation(nested_dissection(graph, seed), graph.size())) << name;
      EXPECT_EQ(nested_dissection(graph, seed), nested_dissection(graph, seed)) << name;
    }
  }
}

double entries(const Graph& graph, const std::vector<Index>& order) {
  double sum = 0.0;
  for (const Index count : elimination_tree(graph, order).counts) sum += count;
  return sum;
}

TEST(Ordering, SavesFillOnAGrid) {
  const Graph graph = block_graph(test::grid(40, 40));
  std::vector<Index> natural(1600);
  for (Index k = 0; k < 1600; ++k) natural[k] = k;
  EXPECT_LT(entries(graph, nested_dissection(graph, 1)), 0.5 * entries(graph, natural));
  EXPECT_LT(entries(graph, minimum_degree(graph)), 0.5 * entries(graph, natural));
}

TEST(Ordering, MinimumDegreeMakesNoFillOnAStar) {
  const Graph graph = block_graph(test::star(50, 0));
  EXPECT_EQ(entries(graph, minimum_degree(graph)), 50 + 49);
}

std::atomic<int> caught{0};

// METIS takes SIGTERM for a failure of its own; here it must not see any.
TEST(Ordering, IsNotDisturbedByTermination) {
  const Graph graph = block_graph(test::grid(100, 100));
  const std::vector<Index> undisturbed = nested_dissection(graph, 1);
  struct sigaction action {
  }, before{};
  action.sa_handler = [](int) { ++caught; };
  sigemptyset(&action.sa_mask);
  ASSERT_EQ(sigaction(SIGTERM, &action, &before), 0);
  std::atomic<bool> over = false;
  const pthread_t here = ::pthread_self();
  std::thread sender([&] {
    for (; !over; std::this_thread::sleep_for(std::chrono::milliseconds(1)))
      ::pthread_kill(here, SIGTERM);
  });
  for (int k = 0; k < 3; ++k) {
    const int earlier = caught;
    EXPECT_EQ(nested_dissection(graph, 1), undisturbed);
    EXPECT_GT(caught, earlier);  // it is not lost either
  }
  over = true;
  sender.join();
  ASSERT_EQ(sigaction(SIGTERM, &before, nullptr), 0);
}

}  // namespace
}  // namespace retiarius

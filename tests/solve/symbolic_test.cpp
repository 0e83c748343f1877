#include "retiarius/solve/symbolic.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "retiarius/solve/linear_solver.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

// Scalars of the lower triangle of the factor, diagonal included, by scalar elimination of the
// blocks in the given order; the sum of squared column lengths beside it.
std::pair<double, double> brute_force(const BlockPattern& pattern,
                                      const std::vector<Index>& order) {
  const Index size = 3 * pattern.blocks();
  std::vector<std::vector<bool>> full(size, std::vector<bool>(size, false));
  std::vector<Index> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<Index>(k);
  const auto fill = [&](Index a, Index b) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) full[3 * a + i][3 * b + j] = full[3 * b + j][3 * a + i] = true;
    }
  };
  for (Index c = 0; c < pattern.blocks(); ++c) {
    fill(position[c], position[c]);
    for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k) {
      fill(position[c], position[pattern.rows()[k]]);
    }
  }
  double entries = 0.0, flops = 0.0;
  for (Index k = 0; k < size; ++k) {
    std::vector<Index> column;
    for (Index r = k; r < size; ++r) {
      if (full[r][k]) column.push_back(r);
    }
    for (const Index a : column) {
      for (const Index b : column) full[a][b] = true;
    }
    const double length = static_cast<double>(column.size());
    entries += length;
    flops += length * length;
  }
  return {entries, flops};
}

TEST(Symbolic, CountsMatchBruteForce) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    if (pattern.blocks() > 200) continue;
    const Symbolic symbolic = analyse_fronts(pattern);
    const auto [entries, flops] = brute_force(pattern, symbolic.order);
    EXPECT_EQ(symbolic.entries, entries) << name;
    EXPECT_EQ(symbolic.flops, flops) << name;
    const auto solver = make_multifrontal_solver();
    solver->analyse(pattern);
    EXPECT_EQ(solver->factor_entries(), entries) << name;
    EXPECT_EQ(solver->factor_flops(), flops) << name;
  }
}

TEST(Symbolic, PatternsThatChangeSoonTakeTheFirstOrder) {
  const BlockPattern pattern = test::hexagon_net(8, 4);
  const auto solver = make_multifrontal_solver();
  for (const bool soon : {true, false, true}) {
    solver->expect_changes(soon);
    solver->analyse(pattern);
    EXPECT_EQ(solver->factor_flops(), analyse_fronts(pattern, soon ? 1 : kOrderTrials).flops);
  }
}

TEST(Symbolic, FrontsCoverEveryBlockOnceAndChildrenFitTheirParents) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    const Symbolic s = analyse_fronts(pattern);
    Index next = 0;
    for (Index f = 0; f < static_cast<Index>(s.fronts.size()); ++f) {
      const Front& front = s.fronts[f];
      EXPECT_EQ(front.first, next) << name;
      next += front.columns;
      EXPECT_EQ(front.panel % kernels::kPadding, 0u);
      EXPECT_EQ(front.below == 0, front.parent == kNone) << name;
      if (front.parent == kNone) continue;
      EXPECT_GT(front.parent, f);
      const Front& parent = s.fronts[front.parent];
      for (Index b = 0; b < front.below; ++b) {
        const Index number = s.rows[front.rows + b];
        const int target = s.targets[front.rows + b];
        const Index there = target < parent.columns ? parent.first + target
                                                    : s.rows[parent.rows + target - parent.columns];
        EXPECT_EQ(there, number) << name;
      }
    }
    EXPECT_EQ(next, pattern.blocks()) << name;
  }
}

TEST(Symbolic, EveryPairIsCopiedOnce) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    std::vector<Index> slots;
    for (const BlockCopy& copy : analyse_fronts(pattern).copies) slots.push_back(copy.slot);
    std::sort(slots.begin(), slots.end());
    ASSERT_EQ(static_cast<Index>(slots.size()), pattern.pairs()) << name;
    for (Index k = 0; k < pattern.pairs(); ++k) EXPECT_EQ(slots[k], k) << name;
  }
}

// Follows a factorisation of the fronts [begin, end) and checks that no two updates that live at
// the same time overlap. `place` tells where an update lies; negative: elsewhere.
template <class Place>
void expect_no_overlap(const Symbolic& s, Index begin, Index end, std::size_t size, Place place) {
  std::set<Index> alive;
  const auto range = [&](Index g) {
    const Front& front = s.fronts[g];
    return std::pair{place(front), place(front) + front.update_ld * front.rows_below()};
  };
  for (Index f = begin; f < end; ++f) {
    if (place(s.fronts[f]) >= 0) {
      const auto [first, last] = range(f);
      EXPECT_LE(last, static_cast<long>(size));
      for (const Index g : alive) {
        EXPECT_TRUE(range(g).second <= first || range(g).first >= last) << f << " and " << g;
      }
      alive.insert(f);
    }
    for (std::size_t c = s.fronts[f].child_begin; c < s.fronts[f].child_end; ++c) {
      alive.erase(s.children[c]);
    }
  }
}

TEST(Symbolic, LivingUpdatesDoNotOverlap) {
  const Symbolic s = analyse_fronts(test::hexagon_net(8, 4));
  const auto serial = [](const Front& front) { return static_cast<long>(front.update); };
  expect_no_overlap(s, 0, static_cast<Index>(s.fronts.size()), s.update_size, serial);
  const auto in_task = [](const Front& front) {
    return front.update_shared ? -1L : static_cast<long>(front.task_update);
  };
  for (const FrontTask& task : s.tasks) {
    expect_no_overlap(s, task.begin, task.end, task.memory, in_task);
  }
}

TEST(Symbolic, OneThreadUsesMemoryAgain) {
  const Symbolic s = analyse_fronts(test::hexagon_net(8, 4));
  EXPECT_LT(s.update_size, (s.shared_size + s.tasks_size) / 2);
}

TEST(Symbolic, MergingWidensFrontsOfAThread) {
  // Without merging a chain of 300 blocks has nearly as many fronts.
  EXPECT_LT(analyse_fronts(test::chain(300)).fronts.size(), 150u);
}

}  // namespace
}  // namespace retiarius

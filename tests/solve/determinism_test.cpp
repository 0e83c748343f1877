#include <gtest/gtest.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "retiarius/solve/symbolic.hpp"
#include "tests/solve/borders.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

class Determinism : public testing::Test {
 protected:
  void TearDown() override { set_threads(1); }
};

// For one right-hand side, then with a border that reaches some of the fronts.
std::vector<Vec3> solution(LinearSolver& solver, const BlockMatrix& matrix) {
  const Index blocks = matrix.pattern->blocks();
  std::vector<Vec3> x = test::random_vector(blocks, 91), bordered;
  const test::Border border(2, blocks, 94, blocks / 3 + 1);
  Eigen::MatrixXd products;
  EXPECT_TRUE(solver.factor(matrix));
  solver.solve(x);
  solver.begin_bordered(border.columns, x, products);
  solver.end_bordered(products.rightCols(1), bordered);
  x.insert(x.end(), bordered.begin(), bordered.end());
  return x;
}

TEST_F(Determinism, ThreadsDoNotChangeABit) {
  for (const auto make : {make_multifrontal_solver, make_piece_solver}) {
    for (const BlockPattern& pattern :
         {test::hexagon_net(8, 4), test::hexagon_net(14, 1), test::grid(40, 40),
          test::chain(3000, 2), test::random_pattern(2000, 2500, 5),
          test::hexagon_net(7, 10, test::Bend::hinged)}) {
      const BlockMatrix matrix = test::random_matrix(pattern, 92);
      set_threads(1);
      const auto serial = make();
      serial->analyse(pattern);
      const std::vector<Vec3> expected = solution(*serial, matrix);
      for (const int count : {2, 4}) {
        set_threads(count);
        const auto fresh = make();
        fresh->analyse(pattern);
        for (int repeat = 0; repeat < 5; ++repeat) EXPECT_EQ(solution(*fresh, matrix), expected);
        // Also where the analysis ran with one thread.
        EXPECT_EQ(solution(*serial, matrix), expected);
      }
    }
  }
}

TEST_F(Determinism, ThreadsDoNotChangeABitOfWhatIsRefactored) {
  for (const auto make : {make_multifrontal_solver, make_piece_solver}) {
    for (const BlockPattern& pattern : {test::hexagon_net(14, 1), test::hexagon_net(8, 4)}) {
      BlockMatrix matrix = test::random_matrix(pattern, 92);
      BlockMatrix changed = matrix;
      std::vector<Index> where;
      for (Index k = 0; k < pattern.blocks(); k += 97) {
        changed.diagonal[k] *= 1.5;
        where.push_back(k);
      }
      const std::vector<Vec3> b = test::random_vector(pattern.blocks(), 93);
      std::vector<Vec3> expected = b;
      set_threads(1);
      const auto serial = make();
      serial->analyse(pattern);
      ASSERT_TRUE(serial->factor(changed));
      serial->solve(expected);
      const auto solver = make();
      solver->keep_parts(true);
      solver->analyse(pattern);
      for (const int count : {1, 2, 4, 1}) {
        set_threads(count);
        ASSERT_TRUE(solver->factor(matrix));
        ASSERT_TRUE(solver->refactor(changed, where));
        std::vector<Vec3> x = b;
        solver->solve(x);
        EXPECT_EQ(x, expected) << count;
      }
    }
  }
}

TEST_F(Determinism, ThreadsDoNotChangeConjugateGradients) {
  const BlockPattern pattern = test::hexagon_net(20, 2);
  const BlockMatrix matrix = test::random_matrix(pattern, 95);
  const auto solver = make_pcg_solver();
  solver->analyse(pattern);
  set_threads(1);
  const std::vector<Vec3> expected = solution(*solver, matrix);
  for (const int count : {2, 4}) {
    set_threads(count);
    EXPECT_EQ(solution(*solver, matrix), expected);
  }
}

TEST_F(Determinism, ThreadsSeeFailures) {
  set_threads(4);
  const BlockPattern pattern = test::hexagon_net(8, 4, test::Bend::hinged);
  const BlockMatrix good = test::random_matrix(pattern, 93);
  for (const auto make : {make_multifrontal_solver, make_piece_solver}) {
    const auto solver = make();
    solver->analyse(pattern);
    for (Index block = 0; block < pattern.blocks(); block += 97) {
      BlockMatrix bad = good;
      bad.diagonal[block](0, 0) = -1.0;
      EXPECT_FALSE(solver->factor(bad)) << block;
    }
    EXPECT_TRUE(solver->factor(good));
  }
}

TEST_F(Determinism, LargeNetsGiveSeveralTasks) {
  EXPECT_GT(analyse_fronts(test::hexagon_net(8, 4)).tasks.size(), 4u);
}

TEST_F(Determinism, AnalysisRepeats) {
  const BlockPattern pattern = test::hexagon_net(6, 3);
  for (const int trials : {1, kOrderTrials})
    EXPECT_EQ(analyse_fronts(pattern, trials).order, analyse_fronts(pattern, trials).order);
}

}  // namespace
}  // namespace retiarius

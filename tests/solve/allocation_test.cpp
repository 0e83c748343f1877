// What the linear solvers allocate.
#include <gtest/gtest.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "tests/solve/borders.hpp"
#include "tests/solve/counted_new.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

TEST(Allocation, IsCounted) {
  const long before = allocations;
  std::vector<Vec3> x(100);
  EXPECT_GT(allocations, before) << "the counting operator new is not in use";
  EXPECT_EQ(x.size(), 100u);
}

TEST(Allocation, FactorAndSolveDoNone) {
  set_threads(1);
  for (const auto make : {make_multifrontal_solver, make_piece_solver}) {
    const BlockPattern pattern = test::hexagon_net(8, 4, test::Bend::hinged);
    const BlockMatrix matrix = test::random_matrix(pattern, 1);
    std::vector<Vec3> x = test::random_vector(pattern.blocks(), 2);
    const test::Border border(1, pattern.blocks(), 3);
    const Eigen::VectorXd c = Eigen::VectorXd::Ones(6);
    Eigen::MatrixXd products;
    const auto solver = make();
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(matrix));
    solver->solve(x);
    solver->begin_bordered(border.columns, x, products);
    solver->end_bordered(c, x);
    const long before = allocations;
    bool good = true;
    for (int repeat = 0; repeat < 3; ++repeat) {
      good = good && solver->factor(matrix);
      solver->solve(x);
      solver->begin_bordered(border.columns, x, products);
      solver->end_bordered(c, x);
    }
    EXPECT_EQ(allocations, before);
    EXPECT_TRUE(good);
  }
}

}  // namespace
}  // namespace retiarius

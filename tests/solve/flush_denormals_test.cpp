#include "retiarius/solve/flush_denormals.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "retiarius/solve/linear_solver.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

double half_of_smallest_normal() {
  volatile double smallest = std::numeric_limits<double>::min();
  return smallest / 2.0;
}

TEST(FlushDenormals, LastsAsLongAsTheObject) {
  EXPECT_GT(half_of_smallest_normal(), 0.0);
#if defined(__SSE2__)
  double inside = 1.0;
  {
    const FlushDenormals flush;
    inside = half_of_smallest_normal();
  }
  EXPECT_EQ(inside, 0.0);
#endif
  EXPECT_GT(half_of_smallest_normal(), 0.0);
}

TEST(FlushDenormals, FactorAndSolveLeaveTheModeAlone) {
  const BlockPattern pattern = test::chain(50, 2);
  const BlockMatrix good = test::random_matrix(pattern, 1);
  BlockMatrix bad = good;
  bad.diagonal[20](0, 0) = -1.0;
  const auto solver = make_multifrontal_solver();
  solver->analyse(pattern);
  EXPECT_FALSE(solver->factor(bad));
  EXPECT_GT(half_of_smallest_normal(), 0.0);
  EXPECT_TRUE(solver->factor(good));
  std::vector<Vec3> x = test::random_vector(50, 2);
  solver->solve(x);
  EXPECT_GT(half_of_smallest_normal(), 0.0);
}

// Forces decay by a factor of ten thousand a block: the far end of the inverse underflows.
TEST(FlushDenormals, DecayBelowTheNormalRangeDoesNoHarm) {
  const BlockPattern pattern = test::chain(200);
  BlockMatrix matrix;
  matrix.reset(pattern);
  for (Mat3& block : matrix.diagonal) block = Mat3::Identity();
  for (Mat3& block : matrix.below) block = 1e-4 * Mat3::Identity();
  std::vector<Vec3> b(200, Vec3::Zero()), product;
  b[0] = Vec3::Ones();
  const auto solver = make_multifrontal_solver();
  solver->analyse(pattern);
  ASSERT_TRUE(solver->factor(matrix));
  std::vector<Vec3> x = b;
  solver->solve(x);
  matrix.multiply(x, product);
  EXPECT_LE(test::distance(product, b), 1e-15);
  EXPECT_NEAR(x[3].x(), -1e-12, 1e-19);
  EXPECT_EQ(x[199].x(), 0.0);
}

}  // namespace
}  // namespace retiarius

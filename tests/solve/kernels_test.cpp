#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "tests/solve/borders.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class Kernels : public testing::Test {
 protected:
  void TearDown() override { set_kernels("auto"); }
};

TEST_F(Kernels, AutoTakesTheLastOfTheAvailable) {
  const std::vector<std::string_view> names = available_kernels();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), "portable");
  set_kernels("portable");
  EXPECT_EQ(kernel_name(), "portable");
  set_kernels("auto");
  EXPECT_EQ(kernel_name(), names.back());
}

TEST_F(Kernels, RefusesUnknownNamesAndKeepsTheChoice) {
  set_kernels("portable");
  try {
    set_kernels("sse9");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("\"sse9\""), HasSubstr("auto, portable")));
  }
  EXPECT_EQ(kernel_name(), "portable");
}

TEST_F(Kernels, AllAgree) {
  const auto solver = make_multifrontal_solver();
  for (const auto& [name, pattern] : test::all_patterns()) {
    const BlockMatrix matrix = test::random_matrix(pattern, 81);
    const std::vector<Vec3> b = test::random_vector(pattern.blocks(), 82);
    const test::Border border(1, pattern.blocks(), 83);
    const Eigen::VectorXd c = Eigen::VectorXd::LinSpaced(6, -1.0, 1.0);
    Eigen::MatrixXd products, expected_products;
    solver->analyse(pattern);
    set_kernels("portable");
    ASSERT_TRUE(solver->factor(matrix));
    std::vector<Vec3> expected = b, expected_bordered;
    solver->solve(expected);
    solver->begin_bordered(border.columns, b, expected_products);
    solver->end_bordered(c, expected_bordered);
    for (const std::string_view kernels : available_kernels()) {
      set_kernels(kernels);
      ASSERT_TRUE(solver->factor(matrix)) << name << ", " << kernels;
      std::vector<Vec3> x = b;
      solver->solve(x);
      EXPECT_LE(test::distance(x, expected), 1e-12 * test::norm(expected))
          << name << ", " << kernels;
      solver->begin_bordered(border.columns, b, products);
      EXPECT_TRUE(products.isApprox(expected_products, 1e-12)) << name << ", " << kernels;
      solver->end_bordered(c, x);
      EXPECT_LE(test::distance(x, expected_bordered), 1e-12 * test::norm(expected_bordered))
          << name << ", " << kernels;
      BlockMatrix bad = matrix;
      if (pattern.blocks() == 0) continue;
      bad.diagonal.back()(2, 2) = -1.0;
      EXPECT_FALSE(solver->factor(bad)) << name << ", " << kernels;
    }
  }
}

}  // namespace
}  // namespace retiarius

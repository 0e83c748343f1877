#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/solve/linear_solver.hpp"
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
    const std::vector<Vec3> seven = test::random_vector(7 * pattern.blocks(), 83);
    solver->analyse(pattern);
    set_kernels("portable");
    ASSERT_TRUE(solver->factor(matrix));
    std::vector<Vec3> expected = b, all_expected = seven;
    solver->solve(expected);
    solver->solve(all_expected);
    for (const std::string_view kernels : available_kernels()) {
      set_kernels(kernels);
      ASSERT_TRUE(solver->factor(matrix)) << name << ", " << kernels;
      std::vector<Vec3> x = b;
      solver->solve(x);
      EXPECT_LE(test::distance(x, expected), 1e-12 * test::norm(expected))
          << name << ", " << kernels;
      std::vector<Vec3> all = seven;
      solver->solve(all);
      EXPECT_LE(test::distance(all, all_expected), 1e-12 * test::norm(all_expected))
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

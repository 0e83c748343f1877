#include "retiarius/solve/linear_solver.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "tests/solve/borders.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;

// The same tests run against the reference and the fast solver.
struct Maker {
  std::string name;
  std::unique_ptr<LinearSolver> (*make)();
};

class LinearSolverTest : public testing::TestWithParam<Maker> {
 protected:
  std::unique_ptr<LinearSolver> solver = GetParam().make();

  template <class Call>
  static std::string error_of(Call call) {
    try {
      call();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_P(LinearSolverTest, TellsItsName) { EXPECT_EQ(solver->name(), GetParam().name); }

TEST_P(LinearSolverTest, SolvesEveryStructure) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    const BlockMatrix matrix = test::random_matrix(pattern, 11);
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(matrix)) << name;
    const std::vector<Vec3> b = test::random_vector(pattern.blocks(), 12);
    std::vector<Vec3> x = b, product;
    solver->solve(x);
    matrix.multiply(x, product);
    EXPECT_LE(test::distance(product, b), 1e-12 * test::norm(b)) << name;
  }
}

TEST_P(LinearSolverTest, FindsAKnownSolution) {
  const BlockPattern pattern = test::hexagon_net(3, 4);
  const BlockMatrix matrix = test::random_matrix(pattern, 21);
  const std::vector<Vec3> expected = test::random_vector(pattern.blocks(), 22);
  std::vector<Vec3> x;
  matrix.multiply(expected, x);
  solver->analyse(pattern);
  ASSERT_TRUE(solver->factor(matrix));
  solver->solve(x);
  EXPECT_LE(test::distance(x, expected), 1e-12 * test::norm(expected));
}

TEST_P(LinearSolverTest, RefusesIndefiniteMatricesAndRecovers) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    if (pattern.blocks() == 0) continue;
    const BlockMatrix good = test::random_matrix(pattern, 31);
    const std::vector<Vec3> b = test::random_vector(pattern.blocks(), 32);
    std::vector<Vec3> expected = b;
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(good)) << name;
    solver->solve(expected);
    for (const Index where : {Index{0}, pattern.blocks() / 2, pattern.blocks() - 1}) {
      for (const double value : {-1.0, 0.0, -kInfinity, kInfinity, std::nan("")}) {
        BlockMatrix bad = good;
        bad.diagonal[where](1, 1) = value;
        EXPECT_FALSE(solver->factor(bad)) << name << ", block " << where << ", " << value;
        std::vector<Vec3> x = b;
        EXPECT_THROW(solver->solve(x), Error);
      }
    }
    ASSERT_TRUE(solver->factor(good)) << name;
    std::vector<Vec3> x = b;
    solver->solve(x);
    EXPECT_EQ(x, expected) << name;
  }
}

TEST_P(LinearSolverTest, RefusesLargeOrBrokenCouplings) {
  const BlockPattern pattern = test::hexagon_net(3, 3);
  const BlockMatrix good = test::random_matrix(pattern, 41);
  solver->analyse(pattern);
  for (const Index slot : {Index{0}, pattern.pairs() / 2, pattern.pairs() - 1}) {
    for (const double value : {1e6, kInfinity, std::nan("")}) {
      BlockMatrix bad = good;
      bad.below[slot](2, 0) = value;
      EXPECT_FALSE(solver->factor(bad)) << slot << ", " << value;
    }
  }
  EXPECT_TRUE(solver->factor(good));
}

// Whatever changed since, and whether parts were kept or not.
TEST_P(LinearSolverTest, RefactorsToTheSameBits) {
  const auto fresh = [&](const BlockMatrix& matrix, std::vector<Vec3> x) {
    const auto other = GetParam().make();
    other->analyse(*matrix.pattern);
    EXPECT_TRUE(other->factor(matrix));
    other->solve(x);
    return x;
  };
  for (const auto& [name, pattern] : test::all_patterns()) {
    if (pattern.blocks() == 0) continue;
    const std::vector<Vec3> b = test::random_vector(pattern.blocks(), 36);
    for (const bool keep : {true, false}) {
      BlockMatrix matrix = test::random_matrix(pattern, 37);
      solver->keep_parts(keep);
      solver->analyse(pattern);
      ASSERT_TRUE(solver->refactor(matrix, {})) << name;  // nothing to go on from
      const auto check = [&](const std::vector<Index>& changed) {
        ASSERT_TRUE(solver->refactor(matrix, changed)) << name;
        std::vector<Vec3> x = b;
        solver->solve(x);
        EXPECT_EQ(x, fresh(matrix, b)) << name << " keep " << keep;
      };
      check({});
      for (const Index where : {Index{0}, pattern.blocks() / 2, pattern.blocks() - 1}) {
        matrix.diagonal[where] *= 1.25;
        check({where});
      }
      for (Index column = 0; column < pattern.blocks(); column += 1 + pattern.blocks() / 5) {
        for (Index s = pattern.starts()[column]; s < pattern.starts()[column + 1]; ++s) {
          matrix.below[s] *= 0.75;
          check({pattern.rows()[s], column, column});
        }
      }
      const Index middle = pattern.blocks() / 2;
      const Mat3 good = matrix.diagonal[middle];
      matrix.diagonal[middle] *= -1.0;
      EXPECT_FALSE(solver->refactor(matrix, {middle})) << name;
      matrix.diagonal[middle] = good;
      check({});
      matrix = test::random_matrix(pattern, 38);
      ASSERT_TRUE(solver->factor(matrix)) << name;
      matrix.diagonal[middle] *= 2.0;
      check({middle});
      solver->keep_parts(!keep);
      matrix.diagonal[middle] *= 2.0;
      check({middle});
    }
  }
}

TEST_P(LinearSolverTest, TakesOneOrderAfterAnother) {
  for (const Index blocks : {30, 5, 80}) {
    const BlockPattern pattern = test::chain(blocks, 2);
    const BlockMatrix matrix = test::random_matrix(pattern, 51);
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(matrix));
    const std::vector<Vec3> b = test::random_vector(blocks, 52);
    std::vector<Vec3> x = b, product;
    solver->solve(x);
    matrix.multiply(x, product);
    EXPECT_LE(test::distance(product, b), 1e-12 * test::norm(b));
  }
}

// A pattern that grows a little, or much, or shrinks again, under the order of the first or not.
TEST_P(LinearSolverTest, FollowsAPatternThatChanges) {
  const BlockPattern net = test::hexagon_net(4, 3);
  std::mt19937 generator(53);
  std::uniform_int_distribution<Index> any(0, net.blocks() - 1);
  for (const int pairs : {0, 1, 5, 300, 2}) {
    BlockPattern pattern = net;
    for (int k = 0; k < pairs; ++k) {
      const Index i = any(generator);
      pattern.couple(i, any(generator));
    }
    pattern.finish();
    const BlockMatrix matrix = test::random_matrix(pattern, 54);
    solver->analyse_again(pattern);
    ASSERT_TRUE(solver->factor(matrix));
    const std::vector<Vec3> b = test::random_vector(pattern.blocks(), 55);
    std::vector<Vec3> x = b, product;
    solver->solve(x);
    matrix.multiply(x, product);
    EXPECT_LE(test::distance(product, b), 1e-12 * test::norm(b)) << pairs;
  }
  const BlockPattern other = test::chain(7);
  solver->analyse_again(other);
  EXPECT_TRUE(solver->factor(test::random_matrix(other, 56)));
}

// Where the order stays it is told; where it does not, all is as with a solver of its own.
TEST(AnalyseAgain, KeepsAnOrderWhileThatIsCheap) {
  const BlockPattern net = test::hexagon_net(6, 2);
  const auto grown = [&](int pairs) {
    BlockPattern pattern = net;
    std::mt19937 generator(57);
    std::uniform_int_distribution<Index> any(0, net.blocks() - 1);
    for (int k = 0; k < pairs; ++k) {
      const Index i = any(generator);
      pattern.couple(i, any(generator));
    }
    pattern.finish();
    return pattern;
  };
  for (auto* make : {make_multifrontal_solver, make_net_solver}) {
    const auto kept = make(), fresh = make();
    kept->analyse(net);
    EXPECT_TRUE(kept->analyse_again(grown(1)));
    const BlockPattern large = grown(400);
    EXPECT_FALSE(kept->analyse_again(large));
    fresh->analyse(large);
    const BlockMatrix matrix = test::random_matrix(large, 58);
    std::vector<Vec3> x = test::random_vector(large.blocks(), 59), y = x;
    ASSERT_TRUE(kept->factor(matrix));
    ASSERT_TRUE(fresh->factor(matrix));
    kept->solve(x);
    fresh->solve(y);
    EXPECT_EQ(x, y);
  }
}

TEST_P(LinearSolverTest, SolvesStiffNetsToTheirCondition) {
  // A light chain of stiff springs, held at one end: condition about 1e8.
  const Index blocks = 1000;
  const BlockPattern pattern = test::chain(blocks);
  BlockMatrix matrix;
  matrix.reset(pattern);
  matrix.diagonal[0] += 1e6 * Mat3::Identity();
  for (Index i = 0; i + 1 < blocks; ++i) {
    matrix.diagonal[i] += 1e6 * Mat3::Identity();
    matrix.diagonal[i + 1] += 1e6 * Mat3::Identity();
    matrix.below[i] -= 1e6 * Mat3::Identity();
  }
  solver->analyse(pattern);
  ASSERT_TRUE(solver->factor(matrix));
  std::vector<Vec3> x(blocks, Vec3(0, 0, 1));  // unit loads: a parabola
  solver->solve(x);
  for (Index i = 0; i < blocks; ++i) {
    const double n = i + 1.0;
    const double expected = 1e-6 * (n * blocks - n * (n - 1.0) / 2.0);
    EXPECT_NEAR(x[i].z(), expected, 1e-9 * expected);
    EXPECT_EQ(x[i].x(), 0.0);
  }
}

TEST_P(LinearSolverTest, CountsADenseFactorExactly) {
  const BlockPattern pattern = test::chain(10, 9);
  solver->analyse(pattern);
  EXPECT_EQ(solver->factor_entries(), 30.0 * 31.0 / 2.0);
  EXPECT_EQ(solver->factor_flops(), 30.0 * 31.0 * 61.0 / 6.0);
}

TEST_P(LinearSolverTest, RefusesUseOutOfOrder) {
  const BlockPattern pattern = test::chain(4), other = test::chain(5);
  BlockMatrix matrix = test::random_matrix(pattern, 1);
  solver->analyse(pattern);
  std::vector<Vec3> x(4, Vec3::Ones());
  EXPECT_THAT(error_of([&] { solver->solve(x); }), HasSubstr("needs a successful factor()"));
  EXPECT_THAT(error_of([&] { solver->factor(test::random_matrix(other, 1)); }),
              HasSubstr("analysed"));
  ASSERT_TRUE(solver->factor(matrix));
  std::vector<Vec3> wrong(3, Vec3::Ones());
  EXPECT_THAT(error_of([&] { solver->solve(wrong); }), HasSubstr("right-hand side"));
  std::vector<Vec3> two_and_a_half(10, Vec3::Ones());
  EXPECT_THAT(error_of([&] { solver->solve(two_and_a_half); }), HasSubstr("10 blocks"));
}

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

TEST_P(LinearSolverTest, SolvesBorderedSystems) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    const Index blocks = pattern.blocks();
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(test::random_matrix(pattern, 61))) << name;
    for (const auto& [bodies, stride] : {std::pair{1, 2}, {1, 50}, {1, 1000000}, {2, 3}, {4, 70}}) {
      const test::Border border(bodies, blocks, 62, stride);
      const std::vector<Vec3> r = test::random_vector(blocks, 63);
      Eigen::MatrixXd products;
      solver->begin_bordered(border.columns, r, products);
      ASSERT_EQ(products.rows(), 6 * bodies);
      ASSERT_EQ(products.cols(), 6 * bodies + 1);
      for (Eigen::Index j = 0; j < products.cols(); ++j) {
        std::vector<Vec3> x = r;
        if (j < products.rows())
          x = border.times(Eigen::VectorXd::Unit(products.rows(), j), blocks);
        solver->solve(x);
        for (Eigen::Index i = 0; i < products.rows(); ++i) {
          const std::vector<Vec3> b =
              border.times(Eigen::VectorXd::Unit(products.rows(), i), blocks);
          EXPECT_NEAR(products(i, j), dot(b, x), 1e-12 * (1.0 + test::norm(b) * test::norm(x)))
              << name << ", " << bodies << " bodies, " << i << ", " << j;
        }
      }
      const Eigen::VectorXd c = Eigen::VectorXd::LinSpaced(6 * bodies, -1.0, 2.0);
      std::vector<Vec3> expected = border.times(-c, blocks), x;
      for (std::size_t i = 0; i < r.size(); ++i) expected[i] += r[i];
      solver->solve(expected);
      for (int again = 0; again < 2; ++again) {
        solver->end_bordered(c, x);
        EXPECT_LE(test::distance(x, expected), 1e-12 * test::norm(expected)) << name << bodies;
      }
    }
  }
}

TEST_P(LinearSolverTest, RepeatsBorderedSystemsForOtherRightSides) {
  for (const auto& [name, pattern] : test::all_patterns()) {
    const Index blocks = pattern.blocks();
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(test::random_matrix(pattern, 67))) << name;
    const test::Border border(2, blocks, 68, 5);
    const std::vector<Vec3> first = test::random_vector(blocks, 69);
    const std::vector<Vec3> second = test::random_vector(blocks, 70);
    const Eigen::VectorXd c = Eigen::VectorXd::LinSpaced(12, -1.0, 2.0);
    Eigen::MatrixXd expected, products;
    std::vector<Vec3> x_expected, x;
    solver->begin_bordered(border.columns, second, expected);
    solver->end_bordered(c, x_expected);
    solver->begin_bordered(border.columns, first, products);
    solver->repeat_bordered(border.columns, second, products);
    solver->end_bordered(c, x);
    EXPECT_EQ(products, expected) << name;
    EXPECT_EQ(x, x_expected) << name;
  }
}

// The reference, with its solutions counted.
class CountedSolver : public LinearSolver {
 public:
  mutable int solutions = 0;

  std::string_view name() const override { return "counted"; }
  void analyse(const BlockPattern& pattern) override { solver_->analyse(pattern); }
  bool factor(const BlockMatrix& matrix) override { return solver_->factor(matrix); }
  void solve(std::vector<Vec3>& x) const override {
    ++solutions;
    solver_->solve(x);
  }
  double factor_entries() const override { return solver_->factor_entries(); }
  double factor_flops() const override { return solver_->factor_flops(); }

 private:
  std::unique_ptr<LinearSolver> solver_ = make_reference_solver();
};

TEST(BorderedSystems, AreRepeatedWithOneSolution) {
  const BlockPattern pattern = test::hexagon_net(2, 3);
  CountedSolver solver;
  solver.analyse(pattern);
  ASSERT_TRUE(solver.factor(test::random_matrix(pattern, 71)));
  const test::Border border(1, pattern.blocks(), 72);
  const std::vector<Vec3> r = test::random_vector(pattern.blocks(), 73);
  Eigen::MatrixXd products;
  EXPECT_THROW(solver.repeat_bordered(border.columns, r, products), Error);
  solver.begin_bordered(border.columns, r, products);
  EXPECT_EQ(solver.solutions, 7);
  solver.repeat_bordered(border.columns, r, products);
  EXPECT_EQ(solver.solutions, 8);
  const test::Border other(2, pattern.blocks(), 74);
  EXPECT_THROW(solver.repeat_bordered(other.columns, r, products), Error);
}

TEST_P(LinearSolverTest, RefusesBordersOutOfOrder) {
  const BlockPattern pattern = test::hexagon_net(2, 3);
  solver->analyse(pattern);
  const test::Border border(1, pattern.blocks(), 64);
  std::vector<Vec3> r = test::random_vector(pattern.blocks(), 65), x;
  Eigen::MatrixXd products;
  EXPECT_THROW(solver->begin_bordered(border.columns, r, products), Error);
  ASSERT_TRUE(solver->factor(test::random_matrix(pattern, 66)));
  EXPECT_THROW(solver->end_bordered(Eigen::VectorXd::Zero(6), x), Error);
  solver->begin_bordered(border.columns, r, products);
  EXPECT_THROW(solver->end_bordered(Eigen::VectorXd::Zero(12), x), Error);
  r.pop_back();
  EXPECT_THROW(solver->begin_bordered(border.columns, r, products), Error);
}

INSTANTIATE_TEST_SUITE_P(Solvers, LinearSolverTest,
                         testing::Values(Maker{"reference", make_reference_solver},
                                         Maker{"multifrontal", make_multifrontal_solver},
                                         Maker{"pieces", make_piece_solver}),
                         [](const auto& each) { return each.param.name; });

TEST(MultifrontalSolver, AgreesWithTheReference) {
  const auto fast = make_multifrontal_solver(), slow = make_reference_solver();
  for (const auto& [name, pattern] : test::all_patterns()) {
    const BlockMatrix matrix = test::random_matrix(pattern, 71);
    fast->analyse(pattern);
    slow->analyse(pattern);
    ASSERT_TRUE(fast->factor(matrix)) << name;
    ASSERT_TRUE(slow->factor(matrix)) << name;
    std::vector<Vec3> x = test::random_vector(pattern.blocks(), 72);
    std::vector<Vec3> expected = x;
    fast->solve(x);
    slow->solve(expected);
    EXPECT_LE(test::distance(x, expected), 1e-12 * test::norm(expected)) << name;
  }
}

TEST(PieceSolver, AgreesWithTheReferenceOnEveryInstructionSet) {
  const auto fast = make_piece_solver(), slow = make_reference_solver();
  for (const std::string_view kernels : available_kernels()) {
    set_kernels(std::string(kernels));
    for (const auto& [name, pattern] : test::all_patterns()) {
      const BlockMatrix matrix = test::random_matrix(pattern, 73);
      fast->analyse(pattern);
      slow->analyse(pattern);
      ASSERT_TRUE(fast->factor(matrix)) << name;
      ASSERT_TRUE(slow->factor(matrix)) << name;
      std::vector<Vec3> x = test::random_vector(pattern.blocks(), 74);
      std::vector<Vec3> expected = x;
      fast->solve(x);
      slow->solve(expected);
      EXPECT_LE(test::distance(x, expected), 1e-12 * test::norm(expected)) << name << kernels;
    }
  }
  set_kernels("auto");
}

TEST(PcgSolver, SolvesToItsTolerance) {
  const auto solver = make_pcg_solver();
  for (const auto& [name, pattern] : test::all_patterns()) {
    const BlockMatrix matrix = test::random_matrix(pattern, 81);
    solver->analyse(pattern);
    ASSERT_TRUE(solver->factor(matrix)) << name;
    const std::vector<Vec3> b = test::random_vector(pattern.blocks(), 82);
    std::vector<Vec3> x = b, product;
    solver->solve(x);
    matrix.multiply(x, product);
    EXPECT_LE(test::distance(product, b), 10.0 * kPcgTolerance * test::norm(b)) << name;
  }
}

TEST(PcgSolver, HasNoAnswerWhereTheMatrixIsNotDefinite) {
  const BlockPattern pattern = test::chain(30);
  BlockMatrix matrix = test::random_matrix(pattern, 83);
  const auto solver = make_pcg_solver();
  solver->analyse(pattern);
  std::vector<Vec3> x = test::random_vector(pattern.blocks(), 84);
  EXPECT_THROW(solver->solve(x), Error);
  matrix.below[7] = 50.0 * Mat3::Identity();  // its blocks on the diagonal are still definite
  ASSERT_TRUE(solver->factor(matrix));
  solver->solve(x);
  EXPECT_FALSE(x[0].allFinite());
  matrix.diagonal[4](1, 1) = -1.0;
  EXPECT_FALSE(solver->factor(matrix));
  matrix.diagonal[4](1, 1) = std::nan("");
  EXPECT_FALSE(solver->factor(matrix));
}

TEST(NetSolver, TakesPiecesWhereMostNodesAreInnerOnes) {
  const auto chosen = [](const BlockPattern& pattern) {
    const auto solver = make_net_solver();
    solver->analyse(pattern);
    return std::string(solver->name());
  };
  EXPECT_EQ(chosen(test::hexagon_net(4, 10, test::Bend::hinged)), "pieces");
  EXPECT_EQ(chosen(test::hexagon_net(12, 1)), "multifrontal");
  EXPECT_EQ(chosen(test::grid(40, 40)), "multifrontal");
  EXPECT_EQ(chosen(test::chain(300)), "multifrontal");
}

}  // namespace
}  // namespace retiarius

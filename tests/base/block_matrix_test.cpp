#include "retiarius/base/block_matrix.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "tests/solve/graphs.hpp"

namespace retiarius {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(BlockPattern, SortsAndRemovesRepetitions) {
  BlockPattern pattern(4);
  pattern.couple(3, 1);
  pattern.couple(1, 3);
  pattern.couple(0, 2);
  pattern.couple(2, 2);
  pattern.couple(1, 0);
  pattern.finish();
  EXPECT_EQ(pattern.pairs(), 3);
  EXPECT_THAT(pattern.starts(), ElementsAre(0, 2, 3, 3, 3));
  EXPECT_THAT(pattern.rows(), ElementsAre(1, 2, 3));
}

TEST(BlockPattern, FindsEverySlotInBothOrders) {
  const BlockPattern pattern = test::random_pattern(50, 300, 7);
  for (Index c = 0; c < pattern.blocks(); ++c) {
    for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k) {
      EXPECT_EQ(pattern.slot(c, pattern.rows()[k]), k);
      EXPECT_EQ(pattern.slot(pattern.rows()[k], c), k);
    }
  }
}

TEST(BlockPattern, GrowsAfterFinish) {
  BlockPattern pattern = test::chain(4);
  pattern.couple(0, 3);
  pattern.finish();
  EXPECT_EQ(pattern.pairs(), 4);
  EXPECT_THAT(pattern.rows(), ElementsAre(1, 3, 2, 3));
}

TEST(BlockPattern, EmptyPatternIsUsable) {
  BlockPattern pattern;
  pattern.finish();
  EXPECT_EQ(pattern.blocks(), 0);
  EXPECT_EQ(pattern.pairs(), 0);
  EXPECT_THAT(pattern.rows(), IsEmpty());
}

template <class Call>
std::string error_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(BlockPattern, NamesWhatIsAbsent) {
  const BlockPattern pattern = test::chain(4);
  EXPECT_THAT(error_of([&] { pattern.slot(3, 0); }),
              HasSubstr("blocks 3 and 0 are not coupled in the pattern of 4 blocks"));
  EXPECT_THAT(error_of([&] { pattern.slot(2, 2); }), HasSubstr("not coupled"));
  EXPECT_THAT(error_of([&] { pattern.slot(-1, 2); }), HasSubstr("not coupled"));
  EXPECT_THAT(error_of([&] { pattern.slot(2, 4); }), HasSubstr("not coupled"));
}

TEST(BlockPattern, RefusesBlocksOutsideAndUseBeforeFinish) {
  BlockPattern pattern(4);
  EXPECT_THAT(error_of([&] { pattern.couple(1, 4); }),
              HasSubstr("cannot couple blocks 1 and 4: the pattern has 4 blocks"));
  EXPECT_THAT(error_of([&] { pattern.couple(-1, 2); }), HasSubstr("cannot couple"));
  pattern.couple(0, 1);
  EXPECT_THAT(error_of([&] { pattern.slot(0, 1); }), HasSubstr("before finish()"));
}

TEST(BlockMatrix, MultipliesAsTheFullSymmetricMatrix) {
  const BlockPattern pattern = test::random_pattern(12, 40, 3);
  const BlockMatrix matrix = test::random_matrix(pattern, 4);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(36, 36);
  for (Index c = 0; c < 12; ++c) {
    full.block<3, 3>(3 * c, 3 * c) = matrix.diagonal[c];
    for (Index k = pattern.starts()[c]; k < pattern.starts()[c + 1]; ++k) {
      const Index r = pattern.rows()[k];
      full.block<3, 3>(3 * r, 3 * c) = matrix.below[k];
      full.block<3, 3>(3 * c, 3 * r) = matrix.below[k].transpose();
    }
  }
  const std::vector<Vec3> x = test::random_vector(12, 5);
  std::vector<Vec3> y;
  matrix.multiply(x, y);
  const Eigen::VectorXd expected = full * Eigen::Map<const Eigen::VectorXd>(x[0].data(), 36);
  for (Index i = 0; i < 12; ++i) EXPECT_LT((y[i] - expected.segment<3>(3 * i)).norm(), 1e-13);
}

TEST(BlockMatrix, ResetSizesAndClears) {
  const BlockPattern small = test::chain(3), large = test::chain(6, 2);
  BlockMatrix matrix = test::random_matrix(small, 1);
  matrix.reset(large);
  EXPECT_EQ(matrix.pattern, &large);
  ASSERT_EQ(matrix.diagonal.size(), 6u);
  ASSERT_EQ(matrix.below.size(), 9u);
  for (const Mat3& block : matrix.diagonal) EXPECT_EQ(block, Mat3::Zero());
  for (const Mat3& block : matrix.below) EXPECT_EQ(block, Mat3::Zero());
}

}  // namespace
}  // namespace retiarius

#include "retiarius/campaign/statistics_rank.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/random.hpp"
#include "retiarius/base/vec.hpp"

namespace retiarius {
namespace {

using ::testing::ElementsAre;

TEST(Ranks, SharedByEqualValues) {
  EXPECT_THAT(ranks({30, 10, 20, 20}), ElementsAre(4, 1, 2.5, 2.5));
  EXPECT_THAT(ranks({5, 5, 5}), ElementsAre(2, 2, 2));
}

// Without ties rho = 1 - 6 sum d^2 / (n (n^2 - 1)); here d = 0, 1, 1, 1, 1.
TEST(RankCorrelation, ByHandWithoutTies) {
  const RankCorrelation r = rank_correlation({1, 2, 3, 4, 5}, {10, 30, 20, 500, 40});
  EXPECT_NEAR(r.rho, 1.0 - 6.0 * 4.0 / (5 * 24), 1e-15);
  // t = 0.8 sqrt(3) / 0.6 with three degrees of freedom, whose distribution function is
  // 1/2 + (atan(u) + u / (1 + u^2)) / pi with u = t / sqrt(3).
  const double u = 0.8 / 0.6;
  EXPECT_NEAR(r.p_value, 1.0 - 2.0 / kPi * (std::atan(u) + u / (1 + u * u)), 1e-14);
}

// Ranks 1, 2.5, 2.5, 4 and 1, 3, 2, 4: covariance 4.5, variances 4.5 and 5.
TEST(RankCorrelation, ByHandWithTies) {
  EXPECT_NEAR(rank_correlation({1, 2, 2, 3}, {1, 3, 2, 4}).rho, 4.5 / std::sqrt(4.5 * 5.0), 1e-15);
}

TEST(RankCorrelation, SeesRanksOnly) {
  const RankCorrelation up = rank_correlation({1, 2, 3, 4}, {1, 10, 100, 1e6});
  EXPECT_EQ(up.rho, 1.0);
  EXPECT_EQ(up.p_value, 0.0);
  EXPECT_EQ(up.interval.high, 1.0);
  EXPECT_EQ(rank_correlation({1, 2, 3}, {3, 2, 1}).rho, -1.0);
}

TEST(RankCorrelation, LeavesOutWhatIsMissing) {
  const RankCorrelation r = rank_correlation({1, NAN, 2, 3, 4}, {1, 7, 2, 3, NAN});
  EXPECT_EQ(r.count, 3u);
  EXPECT_EQ(r.rho, 1.0);
  EXPECT_EQ(r.interval.low, -1.0);
  EXPECT_TRUE(std::isnan(rank_correlation({1, 2, 3}, {5, 5, 5}).rho));
  EXPECT_TRUE(std::isnan(rank_correlation({1, 2}, {1, 2}).rho));
  EXPECT_THROW(rank_correlation({1}, {}), Error);
}

TEST(RankCorrelation, IncompleteBeta) {
  EXPECT_NEAR(incomplete_beta(2, 3, 0.4), 0.5248, 1e-14);  // 6 x^2 - 8 x^3 + 3 x^4
  EXPECT_NEAR(incomplete_beta(0.5, 0.5, 0.25), 2 / kPi * std::asin(0.5), 1e-14);
  EXPECT_NEAR(incomplete_beta(499, 0.5, 0.999), 1.0 - incomplete_beta(0.5, 499, 0.001), 1e-12);
  EXPECT_EQ(incomplete_beta(1, 2, 0), 0.0);
  EXPECT_EQ(incomplete_beta(1, 2, 1), 1.0);
}

// Pairs that are normal with correlation r have Spearman's 6 / pi asin(r / 2).
TEST(RankCorrelation, IntervalAndPValueCoverAsTheySay) {
  constexpr int kRepetitions = 1000, kPairs = 60;
  for (double r : {0.0, 0.5, 0.8}) {
    int covered = 0, significant = 0;
    for (std::uint64_t repetition = 0; repetition < kRepetitions; ++repetition) {
      std::vector<double> x, y;
      for (std::uint64_t k = 0; k < kPairs; ++k) {
        const double u = random_uniform(3, repetition, 2 * k);
        const double angle = 2 * kPi * random_uniform(3, repetition, 2 * k + 1);
        const double a = std::sqrt(-2 * std::log1p(-u)) * std::cos(angle);
        const double b = std::sqrt(-2 * std::log1p(-u)) * std::sin(angle);
        x.push_back(a);
        y.push_back(r * a + std::sqrt(1 - r * r) * b);
      }
      const RankCorrelation found = rank_correlation(x, y);
      covered += found.interval.contains(6 / kPi * std::asin(r / 2)) ? 1 : 0;
      significant += found.p_value < 0.05 ? 1 : 0;
    }
    // Four standard deviations of the count, and one per cent for the approximations.
    const double allowed = 4 * std::sqrt(kRepetitions * 0.95 * 0.05) + 0.01 * kRepetitions;
    EXPECT_NEAR(covered, 0.95 * kRepetitions, allowed) << r;
    if (r == 0.0) {
      EXPECT_NEAR(significant, 0.05 * kRepetitions, allowed);
    }
    if (r == 0.8) {
      EXPECT_EQ(significant, kRepetitions);
    }
  }
}

}  // namespace
}  // namespace retiarius

#include "retiarius/campaign/statistics_distribution.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace retiarius {
namespace {

using ::testing::DoubleEq;
using ::testing::ElementsAre;

TEST(Distribution, OfAFewValues) {
  const SampleDistribution d = distribution({4, NAN, 1, 3, 2});
  EXPECT_EQ(d.count, 4u);
  EXPECT_EQ(d.missing, 1u);
  EXPECT_DOUBLE_EQ(d.mean, 2.5);
  EXPECT_DOUBLE_EQ(d.deviation, std::sqrt(5.0 / 3.0));
  EXPECT_EQ(d.least, 1.0);
  EXPECT_EQ(d.greatest, 4.0);
  EXPECT_DOUBLE_EQ(d.median, 2.5);
  EXPECT_DOUBLE_EQ(d.q25, 1.75);
  EXPECT_DOUBLE_EQ(d.q95, 3.85);
}

TEST(Distribution, OfNothingAndOfOne) {
  EXPECT_TRUE(std::isnan(distribution({}).mean));
  EXPECT_TRUE(std::isnan(distribution({NAN}).median));
  const SampleDistribution one = distribution({5});
  EXPECT_EQ(one.mean, 5.0);
  EXPECT_TRUE(std::isnan(one.deviation));
  EXPECT_EQ(one.q95, 5.0);
}

TEST(Distribution, KeepsTheDigitsOfASmallSpread) {
  const SampleDistribution d = distribution({1e9 + 1, 1e9 + 2, 1e9 + 3});
  EXPECT_DOUBLE_EQ(d.deviation, 1.0);
}

TEST(Histogram, CountsEveryValueOnce) {
  const Histogram h = histogram({0, 0.1, 0.5, 0.9, 1.0, NAN, 0.3, 0.7, 0.05}, 2);
  EXPECT_THAT(h.edges, ElementsAre(0, 0.5, 1.0));
  EXPECT_THAT(h.counts,
              ElementsAre(4u, 4u));  // an edge belongs to the bin above, the last to its own
  EXPECT_EQ(h.bin(1.0), 1u);
  EXPECT_EQ(h.bin(1.1), h.edges.size());
  EXPECT_EQ(h.bin(NAN), h.edges.size());
}

TEST(Histogram, FewDistinctValuesGetABinEach) {
  const Histogram h = histogram({1, 1, 2, 4, 4, 4});
  EXPECT_THAT(h.counts, ElementsAre(2u, 1u, 3u));
  EXPECT_THAT(h.edges, ElementsAre(DoubleEq(0.5), DoubleEq(1.5), DoubleEq(3), DoubleEq(5)));
}

TEST(Histogram, OfNothingAndOfOneValue) {
  EXPECT_TRUE(histogram({NAN}).counts.empty());
  const Histogram h = histogram({3, 3});
  EXPECT_THAT(h.counts, ElementsAre(2u));
  EXPECT_LT(h.edges[0], 3);
  EXPECT_GT(h.edges[1], 3);
  EXPECT_THAT(histogram({0}).counts, ElementsAre(1u));
}

TEST(Histogram, ChoosesBinsByTheSpread) {
  std::vector<double> values;
  for (int k = 0; k < 1000; ++k) values.push_back(k);
  // Freedman and Diaconis: width 2 * 499.5 / 10 = 99.9 over a range of 999.
  EXPECT_EQ(histogram(values).counts.size(), 10u);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/campaign/statistics.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/base/random.hpp"
#include "retiarius/base/vec.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;

TEST(Statistics, NormalQuantileInvertsTheDistribution) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(normal_quantile(0.5), 0.0, 1e-15);
  for (double p : {1e-300, 1e-20, 1e-5, 0.02, 0.3, 0.4999}) {
    const double z = normal_quantile(p);
    EXPECT_NEAR(0.5 * std::erfc(-z / std::sqrt(2.0)) / p, 1.0, 1e-12) << p;
  }
  for (double p : {1e-5, 0.02, 0.3})
    EXPECT_NEAR(normal_quantile(1.0 - p), -normal_quantile(p), 1e-10);
  EXPECT_THROW(normal_quantile(0.0), Error);
  EXPECT_THROW(normal_quantile(1.0), Error);
  EXPECT_THROW(normal_quantile(NAN), Error);
}

// The interval's ends are the probabilities p at which the share lies z standard deviations away:
// |share - p| = z sqrt(p (1 - p) / n).
TEST(Statistics, WilsonIntervalSolvesTheScoreEquation) {
  const double z = normal_quantile(0.975);
  for (auto [s, n] : {std::pair{8, 10}, {1, 7}, {500, 1000}, {37, 40}}) {
    const Interval i = wilson_interval(s, n);
    for (double p : {i.low, i.high})
      EXPECT_NEAR(std::abs(double(s) / n - p), z * std::sqrt(p * (1 - p) / n), 1e-12);
  }
  const Interval eight = wilson_interval(8, 10);
  EXPECT_NEAR(eight.low, 0.490, 5e-4);  // hand values
  EXPECT_NEAR(eight.high, 0.943, 5e-4);
}

TEST(Statistics, WilsonIntervalAtTheEnds) {
  const double z2 = std::pow(normal_quantile(0.975), 2);
  EXPECT_EQ(wilson_interval(0, 10).low, 0.0);
  EXPECT_NEAR(wilson_interval(0, 10).high, z2 / (10 + z2), 1e-14);
  EXPECT_EQ(wilson_interval(10, 10).high, 1.0);
  EXPECT_NEAR(wilson_interval(10, 10).low, 10 / (10 + z2), 1e-14);
  EXPECT_EQ(wilson_interval(0, 0).low, 0.0);
  EXPECT_EQ(wilson_interval(0, 0).high, 1.0);
  EXPECT_LT(wilson_interval(80, 100, 0.8).width(), wilson_interval(80, 100, 0.99).width());
}

TEST(Statistics, WilsonIntervalRefusesNonsense) {
  try {
    wilson_interval(11, 10);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("11 successes of 10 trials"));
  }
  EXPECT_THROW(wilson_interval(-1, 10), Error);
  EXPECT_THROW(wilson_interval(1, 10, 1.0), Error);
}

// The exact probability that the interval holds p.
double coverage(int n, double p) {
  double sum = 0.0;
  for (int s = 0; s <= n; ++s) {
    if (!wilson_interval(s, n).contains(p)) continue;
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(s + 1) - std::lgamma(n - s + 1) +
                    s * std::log(p) + (n - s) * std::log1p(-p));
  }
  return sum;
}

TEST(Statistics, WilsonIntervalCoversAsItSays) {
  for (int n : {10, 30, 100, 300, 1000}) {
    double sum = 0.0;
    int count = 0;
    for (double p = 0.0125; p < 1.0; p += 0.0125) {
      const double c = coverage(n, p);
      sum += c;
      ++count;
      if (n * p * (1 - p) < 5.0) continue;
      EXPECT_GT(c, 0.92) << "n = " << n << ", p = " << p;
      EXPECT_LT(c, 0.98) << "n = " << n << ", p = " << p;
    }
    EXPECT_NEAR(sum / count, 0.95, 0.01) << "n = " << n;
  }
}

// A net that catches what lies within R of its axis, aimed with an error that is normal in both
// directions: P = 1 - exp(-R^2 / (2 sigma^2)).
TEST(Statistics, SuccessProbabilityOfAnAimingErrorLiesInItsInterval) {
  constexpr int kCampaigns = 500, kRuns = 400;
  const double radius = 1.7, expected = 1.0 - std::exp(-0.5 * radius * radius);
  int covered = 0;
  for (std::uint64_t campaign = 0; campaign < kCampaigns; ++campaign) {
    int successes = 0;
    for (std::uint64_t run = 0; run < kRuns; ++run) {
      const double u = random_uniform(7, campaign, 2 * run);
      const double angle = 2 * kPi * random_uniform(7, campaign, 2 * run + 1);
      const double r = std::sqrt(-2.0 * std::log1p(-u));
      successes += std::hypot(r * std::cos(angle), r * std::sin(angle)) < radius ? 1 : 0;
    }
    covered += wilson_interval(successes, kRuns).contains(expected) ? 1 : 0;
  }
  // Four standard deviations of the count about 95 %.
  EXPECT_NEAR(covered, 0.95 * kCampaigns, 4 * std::sqrt(kCampaigns * 0.95 * 0.05));
}

}  // namespace
}  // namespace retiarius

#include "retiarius/study/judgement.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace retiarius {
namespace {

// 1 + h^p for h = 1/4, 1/8, 1/16.
std::vector<double> converging(double p) {
  return {1 + std::pow(0.25, p), 1 + std::pow(0.125, p), 1 + std::pow(0.0625, p)};
}

TEST(Judge, MeasuresTheOrderAndTheLimit) {
  for (double p : {1.0, 2.0, 3.0}) {
    const Judgement j = judge(converging(p), 0.0, 0.02);
    ASSERT_TRUE(j.order) << p;
    EXPECT_NEAR(*j.order, p, 1e-10);
    EXPECT_NEAR(*j.limit, 1.0, 1e-12);
  }
}

TEST(Judge, ComparesTheLastChangeWithTheTolerance) {
  const std::vector<double> v = converging(1.0);  // last change 0.0625 of 1.125
  EXPECT_NEAR(*judge(v, 0.0, 0.1).change, 0.0625 / 1.125, 1e-14);
  EXPECT_EQ(judge(v, 0.0, 0.1).verdict, Verdict::holds);
  EXPECT_EQ(judge(v, 0.0, 0.01).verdict, Verdict::does_not_hold);
  EXPECT_EQ(judge(v, 100.0, 0.01).verdict, Verdict::holds);  // a small number beside its size
}

TEST(Judge, CallsChaoticWhatRefinementDoesNotCalm) {
  EXPECT_EQ(judge({1.0, 1.1, 0.9}, 0.0, 0.02).verdict, Verdict::chaotic);
  EXPECT_FALSE(judge({1.0, 1.1, 0.9}, 0.0, 0.02).order);
  EXPECT_EQ(judge({1.0, 1.1, 1.3}, 0.0, 0.02).verdict, Verdict::chaotic);
  EXPECT_EQ(judge({1.0, 1.2, 1.1}, 0.0, 0.02).verdict, Verdict::does_not_hold);
  EXPECT_EQ(judge({1.0, 1.0001, 1.0003}, 0.0, 0.02).verdict, Verdict::holds);
}

TEST(Judge, SeesNoOrderInRoundOff) {
  const Judgement j = judge({1.0, 1.0 + 4e-15, 1.0 + 5e-15}, 0.0, 0.02);
  EXPECT_EQ(j.verdict, Verdict::holds);
  EXPECT_FALSE(j.order);
}

TEST(Judge, NeedsTwoLevelsAndThreeForAnOrder) {
  EXPECT_EQ(judge({1.0}, 0.0, 0.02).verdict, Verdict::unknown);
  EXPECT_EQ(judge({1.0, NAN, NAN}, 0.0, 0.02).verdict, Verdict::unknown);
  const Judgement two = judge({1.0, 1.2}, 0.0, 0.02);
  EXPECT_EQ(two.verdict, Verdict::does_not_hold);
  EXPECT_FALSE(two.order);
  const Judgement gap = judge({NAN, 1.0, 1.01}, 0.0, 0.02);
  EXPECT_EQ(gap.verdict, Verdict::holds);
  EXPECT_FALSE(gap.order);
}

// A contact that only one of the last two levels sees.
TEST(Judge, DoesNotBelieveWhatComesAndGoes) {
  EXPECT_EQ(judge({1.0, 1.0, NAN}, 0.0, 0.02).verdict, Verdict::does_not_hold);
  EXPECT_EQ(judge({1.0, NAN, 1.0}, 0.0, 0.02).verdict, Verdict::does_not_hold);
}

TEST(Judge, TakesZerosForUnchanged) {
  EXPECT_EQ(judge({0.0, 0.0, 0.0}, 0.0, 0.02).verdict, Verdict::holds);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/report/ticks.hpp"

#include <gmock/gmock.h>

namespace retiarius {
namespace {

using ::testing::ElementsAre;

TEST(NiceAxis, HasRoundTicksAndHoldsTheData) {
  const Axis axis = nice_axis(0.3, 9.7, 5, true);
  EXPECT_EQ(axis.low, 0.0);
  EXPECT_EQ(axis.high, 10.0);
  EXPECT_THAT(axis.labels, ElementsAre("0", "2", "4", "6", "8", "10"));
}

TEST(NiceAxis, KeepsTightEndsAtTheData) {
  const Axis axis = nice_axis(0.0, 2.05, 4, false);
  EXPECT_EQ(axis.high, 2.05);
  EXPECT_THAT(axis.labels, ElementsAre("0.0", "0.5", "1.0", "1.5", "2.0"));
}

TEST(NiceAxis, WritesSmallNumbersInAPowerOfAThousand) {
  const Axis axis = nice_axis(-2e-13, 4e-13, 3, true);
  EXPECT_EQ(axis.exponent, -15);
  EXPECT_THAT(axis.labels, ElementsAre("\u2212200", "0", "200", "400"));
}

TEST(NiceAxis, WidensARangeOfLengthZero) {
  EXPECT_THAT(nice_axis(0.0, 0.0, 2, true).labels, ElementsAre("\u22121", "0", "1"));
  const Axis axis = nice_axis(7.0, 7.0, 2, true);
  EXPECT_LT(axis.low, 7.0);
  EXPECT_GT(axis.high, 7.0);
}

// Constant but for rounding: neither an endless loop nor a million ticks.
TEST(NiceAxis, SurvivesARangeOfRounding) {
  const Axis axis = nice_axis(12.5, 12.500000000000002, 5, true);
  EXPECT_LE(axis.ticks.size(), 12u);
  EXPECT_GE(axis.ticks.size(), 2u);
}

TEST(PowerOfTen, HasSuperscriptDigits) {
  EXPECT_EQ(power_of_ten(0), "");
  EXPECT_EQ(power_of_ten(-12), "10\u207b\u00b9\u00b2");
}

}  // namespace
}  // namespace retiarius

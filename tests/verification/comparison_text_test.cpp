#include "verification/framework/comparison_text.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/verification/made_results.hpp"

namespace retiarius::verification {
namespace {

TEST(Printed, WritesNumbersAsPeopleDo) {
  EXPECT_EQ(printed(0.0, 3), "0");
  EXPECT_EQ(printed(-1.5, 3), "\u22121.50");
  EXPECT_EQ(printed(9.97, 2), "10");
  EXPECT_EQ(printed(3.14159e-5, 2), "3.1\u00b710\u207b\u2075");
  EXPECT_EQ(printed(2.0e7, 1), "2\u00b710\u2077");
  EXPECT_EQ(printed(NAN, 2), "not a number");
}

TEST(OursText, GoesAsFarAsTheBound) {
  const Comparison c = testing::made_comparison();
  EXPECT_EQ(ours_text(c), "0.123457");
  EXPECT_EQ(reference_text(c), "0.123457");
  EXPECT_EQ(error_text(c), "2.1\u00b710\u207b\u2077 m");
  EXPECT_EQ(bound_text(c), "1\u00b710\u207b\u2076 m");
}

TEST(OursText, TakesARelativeBoundFromTheReference) {
  Comparison c = testing::made_comparison();
  c.kind = ErrorKind::relative;
  c.ours = 1234.5678;
  c.reference = 1234.0;
  c.bound = 1e-3;
  EXPECT_EQ(ours_text(c), "1235");
  EXPECT_EQ(reference_text(c), "1234");
  EXPECT_EQ(error_text(c), "4.6\u00b710\u207b\u2074 rel.");
}

TEST(ErrorText, DoesNotShowWhatRoundOffDecides) {
  Comparison c = testing::made_comparison();
  c.unit.assign(1, '1');
  c.reference = 0.0;
  c.bound = 1e-12;
  const auto all = [&] { return ours_text(c) + "|" + error_text(c); };
  c.ours = 3.1e-14;
  const std::string one = all();
  c.ours = -8.0e-16;
  EXPECT_EQ(one, all());
  EXPECT_EQ(one, "0|< 1\u00b710\u207b\u00b9\u00b2 abs.");
  c.bound = 1e-3;
  EXPECT_EQ(error_text(c), "< 1\u00b710\u207b\u2075 abs.");
  c.ours = 2.34e-5;
  EXPECT_EQ(error_text(c), "2\u00b710\u207b\u2075 abs.");
  c.ours = 2.34e-4;
  EXPECT_EQ(error_text(c), "2.3\u00b710\u207b\u2074 abs.");
}

TEST(ErrorText, ShowsAMissedBoundOfRoundOff) {
  Comparison c = testing::made_comparison();
  c.bound = 1e-12;
  EXPECT_EQ(error_text(c), "2.1\u00b710\u207b\u2077 m");
}

TEST(VerdictWord, TellsFourKindsApart) {
  const auto rungs = testing::made_rungs();
  EXPECT_EQ(verdict_word(rungs[0].result), "ok");
  EXPECT_EQ(verdict_word(rungs[1].result), "MISS");
  EXPECT_EQ(verdict_word(rungs[2].result), "FAILED");
  EXPECT_EQ(verdict_word(rungs[3].result), "drawn");
}

TEST(TallyOfRungs, CountsCasesAndComparisons) {
  const Tally t = tally(testing::made_rungs());
  EXPECT_EQ(t.cases, 4u);
  EXPECT_EQ(t.passed, 2u);
  EXPECT_EQ(t.comparisons, 3u);
  EXPECT_EQ(t.within, 2u);
}

}  // namespace
}  // namespace retiarius::verification

#include "verification/framework/results_text.hpp"

#include <gmock/gmock.h>

#include "tests/verification/made_results.hpp"

namespace retiarius::verification {
namespace {

using ::testing::HasSubstr;

TEST(CaseText, MarksTheComparisonThatMisses) {
  const std::string text = case_text(testing::made_rungs()[1]);
  EXPECT_THAT(text, HasSubstr("  ok   tip deflection"));
  EXPECT_THAT(text, HasSubstr("  MISS tip deflection"));
}

TEST(CaseText, TellsWhyACaseBrokeOff) {
  EXPECT_THAT(case_text(testing::made_rungs()[2]),
              HasSubstr("FAILED: the step at 0.3 s did not converge"));
}

TEST(CaseText, SaysWhereThereIsNothingToCompareWith) {
  EXPECT_THAT(case_text(testing::made_rungs()[3]), HasSubstr("no published values"));
}

TEST(VerdictText, NamesCasesThatMissed) {
  EXPECT_EQ(verdict_text(testing::made_rungs()),
            "2 of 4 cases passed, 2 of 3 comparisons within their bounds\nmissed: wrong broken\n");
}

TEST(ListText, GroupsCases) {
  std::vector<const Case*> cases;
  for (const Case& c : testing::made_cases()) cases.push_back(&c);
  EXPECT_THAT(list_text(cases), HasSubstr("Rods\n  elastica  Tip-loaded elastica (Fig. 14)\n"));
}

}  // namespace
}  // namespace retiarius::verification

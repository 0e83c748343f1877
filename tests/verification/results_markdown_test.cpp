#include "verification/framework/results_markdown.hpp"

#include <gmock/gmock.h>

#include "tests/verification/made_results.hpp"

namespace retiarius::verification {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string good(const std::vector<Rung>& rungs) {
  return results_markdown(rungs, {}, "verification", false);
}

TEST(ResultsMarkdown, SummarisesAndLinks) {
  const std::string text = good(testing::good_rungs());
  EXPECT_THAT(text, HasSubstr("**2 of 2 cases passed, 1 of 1 comparisons"));
  EXPECT_THAT(text, HasSubstr("| [Tip-loaded elastica](#elastica) | Fig. 14 | 1 | ok |"));
  EXPECT_THAT(text, HasSubstr("| [A case without published values](#drawn) |  | no published "
                              "values | drawn |"));
  EXPECT_THAT(text, HasSubstr("<a id=\"elastica\"></a>"));
  EXPECT_THAT(text, HasSubstr("](verification/elastica-1.svg)"));
}

TEST(ResultsMarkdown, TellsComparisonsWithTheirArguments) {
  const std::string text = good(testing::good_rungs());
  EXPECT_THAT(text, HasSubstr("| tip deflection | 0.123457 m | 0.123457 m | "
                              "2.1\u00b710\u207b\u2077 m | 1\u00b710\u207b\u2076 m (1) | ok | "
                              "Euler 1744 |"));
  EXPECT_THAT(text, HasSubstr("1. one unit of the last printed digit\n"));
  EXPECT_THAT(text, HasSubstr("Linear theory stops at a load of one.\n"));
}

TEST(ResultsMarkdown, ShoutsWhatFails) {
  const std::string text = good(testing::made_rungs());
  EXPECT_THAT(text, HasSubstr("| [A case that misses](#wrong) |  | 2 | **MISS** |"));
  EXPECT_THAT(text, HasSubstr("**Broke off:** the step at 0.3 s did not converge"));
}

TEST(ResultsMarkdown, DoesNotDependOnTheMachine) {
  std::vector<Rung> one = testing::good_rungs(), other = one;
  other[0].result.wall_time = 77.0;
  other[0].result.comparisons[0].ours *= 1.0 + 1e-13;
  EXPECT_EQ(good(one), good(other));
  other[0].result.comparisons[0].ours += 2e-7;
  EXPECT_NE(good(one), good(other));
}

TEST(ResultsMarkdown, KeepsTextFromBeingTakenForMarkup) {
  EXPECT_THAT(good(testing::good_rungs()), HasSubstr("![Deflection &lt;a\\|b>]"));
}

TEST(ResultsMarkdown, SaysWhenItIsOfTheQuickForm) {
  EXPECT_THAT(results_markdown({}, {}, "figures", true), HasSubstr("of the quick form"));
  EXPECT_THAT(good({}), Not(HasSubstr("of the quick form")));
}

TEST(ResultsMarkdown, ShowsWhatOtherProgramsGave) {
  const Recorded recorded =
      parse_recorded("# About.\nscene,net,1,2\nvalue,net,sag,m,0.5,0.5001,0.0001,0.001\n");
  const std::string text = results_markdown({}, recorded, "figures", false);
  EXPECT_THAT(text, HasSubstr("## Independent programs\n\nAbout.\n"));
  EXPECT_THAT(text, HasSubstr("| net | 1.0 s | 2.0 s |"));
  EXPECT_THAT(good({}), Not(HasSubstr("Independent programs")));
}

}  // namespace
}  // namespace retiarius::verification

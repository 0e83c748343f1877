#include "verification/framework/page.hpp"

#include <gmock/gmock.h>

#include "tests/verification/made_results.hpp"

namespace retiarius::verification {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(VerificationPage, SaysFirstThatAllIsWell) {
  const std::string page = verification_page(testing::good_rungs(), {});
  EXPECT_THAT(page,
              HasSubstr("<section class=\"verdict good\"><p class=\"big\">All within bounds"));
  EXPECT_THAT(page, HasSubstr("2 of 2 cases passed, 1 of 1 comparisons"));
  EXPECT_THAT(page, Not(HasSubstr("MISS")));
}

TEST(VerificationPage, ShowsFailuresAtTheTopInTheContentsAndInTheirPlace) {
  const std::string page = verification_page(testing::made_rungs(), {});
  EXPECT_THAT(page, HasSubstr("<section class=\"verdict bad\"><p class=\"big\">Not all within"));
  EXPECT_THAT(page, HasSubstr("<a href=\"#wrong\">wrong</a>: a bound is missed"));
  EXPECT_THAT(page, HasSubstr("broke off: the step at 0.3 s did not converge"));
  EXPECT_THAT(page, HasSubstr("<span class=\"badge miss\">MISS</span><a href=\"#wrong\""));
  EXPECT_THAT(page, HasSubstr("<span class=\"badge miss\">FAILED</span><a href=\"#broken\""));
  EXPECT_THAT(page, HasSubstr("<article id=\"wrong\" class=\"bad\">"));
  EXPECT_THAT(page, HasSubstr("<tr class=\"missed\">"));
}

TEST(VerificationPage, NeverFoldsATableWithAMiss) {
  std::vector<Rung> rungs = testing::good_rungs();
  std::vector<Comparison>& all = rungs[0].result.comparisons;
  all.assign(20, all[0]);
  EXPECT_THAT(verification_page(rungs, {}), HasSubstr("<details><summary>20 comparisons"));
  all[7].ours = 1.0;
  EXPECT_THAT(verification_page(rungs, {}), HasSubstr("<details open><summary>20 comparisons"));
}

TEST(VerificationPage, GivesEachBoundItsArgument) {
  const std::string page = verification_page(testing::good_rungs(), {});
  EXPECT_THAT(page, HasSubstr("href=\"#elastica-why-1\""));
  EXPECT_THAT(page, HasSubstr("<li id=\"elastica-why-1\">one unit of the last printed digit</li>"));
}

TEST(VerificationPage, NamesASharedReferenceOnceAndOthersByTheRow) {
  std::vector<Rung> rungs = testing::good_rungs();
  EXPECT_THAT(verification_page(rungs, {}), HasSubstr("Reference: Euler 1744."));
  rungs[0].result.comparisons.push_back(testing::made_comparison());
  rungs[0].result.comparisons[1].source = "Bernoulli 1691";
  const std::string page = verification_page(rungs, {});
  EXPECT_THAT(page, HasSubstr("<td data-l=\"source\">Bernoulli 1691</td>"));
  EXPECT_THAT(page, Not(HasSubstr("Reference:")));
}

TEST(VerificationPage, HoldsChartsWithCaptionAndSourceAndSafeText) {
  const std::string page = verification_page(testing::good_rungs(), {});
  EXPECT_THAT(page, HasSubstr("<h4>Deflection &lt;a|b&gt;</h4><svg "));
  EXPECT_THAT(page, HasSubstr("EI = 1 N m2. <span class=\"soft\">Source: Euler 1744.</span>"));
  EXPECT_THAT(page, HasSubstr("A rod &amp; its tip."));
  EXPECT_THAT(page, HasSubstr("No published values: drawn"));
  EXPECT_THAT(page, Not(HasSubstr("<a|b>")));
}

TEST(VerificationPage, RefersToNothingOutside) {
  const std::string page = verification_page(testing::made_rungs(), {});
  EXPECT_THAT(page, Not(ContainsRegex("(src|href)=\"?http")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
}

TEST(VerificationPage, FollowsTheReadersPreferenceForDark) {
  EXPECT_THAT(verification_page({}, {}), HasSubstr("prefers-color-scheme:dark"));
}

TEST(VerificationPage, TellsTheFormAndShowsOtherPrograms) {
  PageOptions options;
  options.quick = true;
  EXPECT_THAT(verification_page({}, options), HasSubstr("quick form"));
  EXPECT_THAT(verification_page({}, options), Not(HasSubstr("Independent programs")));
  options.recorded =
      parse_recorded("# About.\nscene,net,1,2\nvalue,net,sag,m,0.5,0.5001,0.0001,0.001\n");
  EXPECT_THAT(verification_page({}, options), HasSubstr("id=\"independent-programs\""));
  EXPECT_THAT(verification_page({}, options), HasSubstr("net: sag"));
}

}  // namespace
}  // namespace retiarius::verification

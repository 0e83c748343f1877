#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "retiarius/study/converge_charts.hpp"
#include "retiarius/study/converge_html.hpp"
#include "retiarius/study/converge_json.hpp"
#include "tests/study/small_nets.hpp"

namespace retiarius {
namespace {

using ::testing::ContainsRegex;
using testing::falling_net;
using ::testing::HasSubstr;
using ::testing::Not;

const Study& study() {
  static const Study result = converge(plan_levels(falling_net(), 3, Vary::both));
  return result;
}

// One level that failed, by hand.
Study with_failure() {
  Study broken = study();
  broken.levels[2].outcome = Outcome::failed;
  broken.levels[2].reason = "the <step> did not converge";
  broken.series[0].trends[0].values[2] = NAN;
  broken.series[0].trends[0].judgement.verdict = Verdict::chaotic;
  return broken;
}

TEST(ConvergeCharts, DrawEveryLevelAndTheMeasuresAgainstTheStep) {
  const std::vector<Chart> charts = converge_charts(study(), 0);
  ASSERT_GE(charts.size(), 4u);
  EXPECT_EQ(charts[0].title, "Mouth area");
  ASSERT_EQ(charts[0].curves.size(), 3u);
  EXPECT_EQ(charts[0].curves[1].name, "h = 0.0005 s");
  EXPECT_EQ(charts[0].curves[1].x.size(), 11u);
  const Chart& measures = charts.back();
  EXPECT_EQ(measures.x_label, "step h / s");
  EXPECT_TRUE(measures.log_x);
  EXPECT_LE(measures.curves.size(), 6u);
  for (const Curve& curve : measures.curves) {
    EXPECT_EQ(curve.y[2], 0.0);  // the finest level is the measure
    // First order: with h, h/2, h/4 the distances are 3 to 1.
    EXPECT_NEAR(curve.y[0] / curve.y[1], 3.0, 0.25) << curve.name;
  }
}

TEST(ConvergeHtml, ShowsVerdictsLevelsAndCharts) {
  const std::string page = converge_html(study());
  EXPECT_THAT(page, HasSubstr("<h1>A falling net</h1>"));
  EXPECT_THAT(page, HasSubstr("All quantities hold"));
  EXPECT_THAT(page, HasSubstr("<h2>Finer time step</h2>"));
  EXPECT_THAT(page, HasSubstr("<h2>Finer mesh</h2>"));
  EXPECT_THAT(page, HasSubstr("aria-labelledby=\"s1-1-t"));
  EXPECT_THAT(page, Not(ContainsRegex("(src|href)=\"?http")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
}

TEST(ConvergeHtml, ShowsWhatFailedAndWhatDoesNotHold) {
  const std::string page = converge_html(with_failure());
  EXPECT_THAT(page, HasSubstr("Not all quantities hold"));
  EXPECT_THAT(page, HasSubstr("failed: the &lt;step&gt; did not converge"));
  EXPECT_THAT(page, HasSubstr("<span class=\"badge miss\">chaotic</span>"));
}

TEST(ConvergeJson, HoldsLevelsAndTrends) {
  const auto all = nlohmann::json::parse(converge_json(with_failure()));
  EXPECT_EQ(all["format"], 1);
  EXPECT_EQ(all["tolerance"], 0.02);
  EXPECT_EQ(all["levels"][2]["outcome"], "failed");
  EXPECT_EQ(all["levels"][4]["segments"], 8);
  EXPECT_EQ(all["series"][1]["varied"], "mesh");
  EXPECT_EQ(all["series"][1]["levels"][2], 4);
  const auto& quantity = all["series"][0]["quantities"][0];
  EXPECT_TRUE(quantity["values"][2].is_null());
  EXPECT_EQ(quantity["verdict"], "chaotic");
}

}  // namespace
}  // namespace retiarius

#include "verification/framework/results_json.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/verification/made_results.hpp"

namespace retiarius::verification {
namespace {

using Json = nlohmann::json;

TEST(ResultsJson, HoldsVerdictComparisonsAndCurves) {
  const Json all = Json::parse(results_json(testing::made_rungs(), true));
  EXPECT_EQ(all["format"], 1);
  EXPECT_EQ(all["quick"], true);
  EXPECT_EQ(all["passes"], false);
  ASSERT_EQ(all["cases"].size(), 4u);
  const Json& good = all["cases"][0];
  EXPECT_EQ(good["name"], "elastica");
  EXPECT_EQ(good["group"], "Rods");
  EXPECT_EQ(good["passes"], true);
  EXPECT_EQ(good["comparisons"][0]["ours"], 0.123456789);
  EXPECT_EQ(good["comparisons"][0]["error_kind"], "absolute");
  EXPECT_EQ(good["comparisons"][0]["argument"], "one unit of the last printed digit");
  EXPECT_EQ(good["charts"][0]["curves"][1]["y"], Json::parse("[0.0, 1.0, 4.0]"));
  EXPECT_EQ(all["cases"][1]["comparisons"][1]["passes"], false);
  EXPECT_EQ(all["cases"][2]["failure"], "the step at 0.3 s did not converge");
}

TEST(ResultsJson, WritesNullForWhatIsNotFinite) {
  std::vector<Rung> rungs = testing::good_rungs();
  rungs[0].result.comparisons[0].ours = NAN;
  rungs[0].result.charts[0].curves[0].y[1] = INFINITY;
  const Json all = Json::parse(results_json(rungs, false));
  EXPECT_TRUE(all["cases"][0]["comparisons"][0]["ours"].is_null());
  EXPECT_TRUE(all["cases"][0]["charts"][0]["curves"][0]["y"][1].is_null());
  EXPECT_EQ(all["passes"], false);
}

}  // namespace
}  // namespace retiarius::verification

#include "retiarius/record/summary_json.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "retiarius/record/file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::SampleRun;
using testing::TemporaryFolder;

BuildInfo some_build() {
  return {"0.1.0",    "v0.1.0",          "gcc 12", "Release", {{"native", "off"}},
          "portable", {{"fmt", "9.1.0"}}};
}

nlohmann::json written(const SampleRun& run, Outcome outcome) {
  TemporaryFolder folder;
  SummaryJson recorder(folder.path(), some_build());
  recorder.begin(run.model());
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json"));
  recorder.end(run.report(outcome));
  return nlohmann::json::parse(read_whole_file(folder / "summary.json"));
}

TEST(SummaryJson, HoldsOutcomePhasesAndMeasures) {
  const auto summary = written(SampleRun(), Outcome::finished);
  EXPECT_EQ(summary["outcome"], "finished");
  EXPECT_EQ(summary["reason"], "");
  ASSERT_EQ(summary["phases"].size(), 2u);
  const auto& phase = summary["phases"][0];
  EXPECT_EQ(phase["name"], "shoot");
  EXPECT_EQ(phase["kind"], "shoot");
  EXPECT_EQ(phase["start"], 0.0);
  EXPECT_EQ(phase["end"], 0.5);
  EXPECT_EQ(phase["trigger"], "time >= 0.5");
  EXPECT_EQ(phase["measures"]["mouth_area_max"], 4.0);
  const auto& measures = summary["measures"];
  EXPECT_EQ(measures["mouth_area_max"], 4.0);
  EXPECT_EQ(measures["closed"], false);
  EXPECT_EQ(measures["steps"], 200);
  EXPECT_TRUE(measures["steps"].is_number_integer());
  EXPECT_EQ(summary["units"]["mouth_area_max"], "m2");
}

TEST(SummaryJson, TellsWhatWasChosen) {
  const SampleRun run;
  TemporaryFolder folder;
  RunModel model = run.model();
  Choice explicitly, named;
  explicitly.method = Method::explicit_differences;
  explicitly.method_reason = "it costs less";
  model.choices = {{"shoot", explicitly}, {"close", named}};
  SummaryJson recorder(folder.path(), some_build());
  recorder.begin(model);
  recorder.end(run.report(Outcome::finished));
  const auto summary = nlohmann::json::parse(read_whole_file(folder / "summary.json"));
  const nlohmann::json expected = {
      {{"phase", "shoot"}, {"integrator", {{"taken", "explicit"}, {"reason", "it costs less"}}}}};
  EXPECT_EQ(summary["chosen"], nlohmann::json::array({expected[0]}));
}

TEST(SummaryJson, WritesNullForAbsentAndForNaN) {
  const auto summary = written(SampleRun(), Outcome::finished);
  EXPECT_TRUE(summary["measures"].at("first_contact_time").is_null());
  EXPECT_TRUE(summary["measures"].at("peak_strain").is_null());
}

TEST(SummaryJson, SaysWhyARunEnded) {
  const auto summary = written(SampleRun(), Outcome::failed);
  EXPECT_EQ(summary["outcome"], "failed");
  EXPECT_EQ(summary["reason"], "step at t = 0.3 s does not converge");
  EXPECT_EQ(written(SampleRun(), Outcome::interrupted)["outcome"], "interrupted");
  EXPECT_EQ(written(SampleRun(), Outcome::broke)["outcome"], "broke");
}

TEST(SummaryJson, NamesVersionsOptionsKernelsAndSeed) {
  const auto summary = written(SampleRun(), Outcome::finished);
  EXPECT_EQ(summary["versions"]["retiarius"], "0.1.0");
  EXPECT_EQ(summary["versions"]["revision"], "v0.1.0");
  EXPECT_EQ(summary["versions"]["compiler"], "gcc 12");
  EXPECT_EQ(summary["versions"]["libraries"]["fmt"], "9.1.0");
  EXPECT_EQ(summary["options"]["native"], "off");
  EXPECT_EQ(summary["options"]["build_type"], "Release");
  EXPECT_EQ(summary["kernels"], "portable");
  EXPECT_EQ(summary["seed"], 7);
}

// Comparisons of two runs drop `timings` (and the measure wall_time); nothing else may differ.
TEST(SummaryJson, KeepsHostAndClockUnderTimings) {
  const SampleRun run;
  const std::string a = summary_text(run.model(), run.report(), some_build(), {"h", "a", "b", 1});
  const std::string b = summary_text(run.model(), run.report(), some_build(), {"i", "c", "d", 2});
  auto left = nlohmann::json::parse(a), right = nlohmann::json::parse(b);
  EXPECT_NE(left, right);
  left.erase("timings");
  right.erase("timings");
  EXPECT_EQ(left, right);
}

TEST(SummaryJson, IsWrittenForARunThatWasNeverBuilt) {
  RunReport report;
  report.outcome = Outcome::failed;
  report.reason = "bad \xff byte";
  const auto summary =
      nlohmann::json::parse(summary_text(RunModel{}, report, BuildInfo{}, Timings{}));
  EXPECT_TRUE(summary["title"].is_null());
  EXPECT_EQ(summary["outcome"], "failed");
}

}  // namespace
}  // namespace retiarius

// What stays of each run, and the limits.
#include <gmock/gmock.h>

#include "tests/campaign/small_campaign.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::monte_carlo;
using testing::ProcessResult;
using testing::query;
using testing::WorkFolder;

void run_campaign(const WorkFolder& folder, const std::string& more) {
  testing::write_small_campaign(folder, monte_carlo(4), more);
  const ProcessResult run = folder.run({"campaign", "run", "c.toml", "--jobs", "2", "--out", "o"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

std::string kept(const WorkFolder& folder) {
  return query(folder, "o",
               "SELECT group_concat(id || ':' || kept, ' ') FROM runs WHERE kept NOT "
               "NULL");
}

TEST(Keep, NothingButMeasures) {
  const WorkFolder folder;
  run_campaign(folder, "");
  EXPECT_EQ(kept(folder), "");
  EXPECT_FALSE(folder.has("o/runs"));
}

TEST(Keep, HistoryOfAll) {
  const WorkFolder folder;
  run_campaign(folder, "[keep]\nwhat = \"history\"\n");
  EXPECT_EQ(kept(folder), "0:runs/0 1:runs/1 2:runs/2 3:runs/3");
  EXPECT_GT(testing::line_count(folder.read("o/runs/2/history.csv")), 3u);
  EXPECT_FALSE(folder.has("o/runs/2/run.h5"));
}

TEST(Keep, FramesOfASample) {
  const WorkFolder folder;
  run_campaign(folder, "[keep]\nwhat = \"sample\"\nids = [1]\nevery = 3\n");
  EXPECT_EQ(kept(folder), "0:runs/0 1:runs/1 3:runs/3");
  EXPECT_TRUE(folder.has("o/runs/1/report.html"));
  EXPECT_TRUE(folder.has("o/runs/1/run.h5"));
  EXPECT_FALSE(folder.has("o/runs/1.part"));
}

TEST(Keep, FramesOfRunsWithoutSuccess) {
  const WorkFolder folder;
  run_campaign(folder, "[keep]\nwhat = \"failures\"\n");
  EXPECT_EQ(kept(folder), "0:runs/0 1:runs/1 2:runs/2 3:runs/3");  // none captures anything
}

TEST(Limits, TimeAndStepsEndRunsAtTheSamePlace) {
  const WorkFolder folder;
  run_campaign(folder, "[limits]\ntime = 0.03\n");
  EXPECT_EQ(query(folder, "o", "SELECT count(*) FROM runs WHERE outcome = 'limit' AND steps = 3"),
            "4");
  EXPECT_EQ(query(folder, "o", "SELECT reason FROM runs"),
            "its mission time reached the limit of 0.03 s");
  EXPECT_EQ(query(folder, "o", "SELECT count(*) FROM runs WHERE success IS NULL"), "4");
  const WorkFolder other;
  run_campaign(other, "[limits]\nsteps = 2\n");
  EXPECT_EQ(query(other, "o", "SELECT count(*) FROM runs WHERE outcome = 'limit' AND steps = 2"),
            "4");
}

}  // namespace
}  // namespace retiarius

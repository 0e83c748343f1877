// What collect makes of the shards, and what it refuses.
#include "retiarius/campaign/collect.hpp"

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>

#include "retiarius/campaign/shard.hpp"
#include "retiarius/campaign/sqlite.hpp"
#include "tests/campaign/small_campaign.hpp"

namespace retiarius {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::monte_carlo;
using ::testing::Not;
using testing::ProcessResult;
using testing::WorkFolder;

fs::path first_shard(const WorkFolder& folder, const std::string& out) {
  return find_shards(folder / out).at(0);
}

class Collect : public ::testing::Test {
 protected:
  Collect() {
    testing::write_small_campaign(folder_, monte_carlo(5));
    const ProcessResult run =
        folder_.run({"campaign", "run", "c.toml", "--jobs", "1", "--out", "o"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  ProcessResult collect_again() {
    return folder_.run({"campaign", "collect", "c.toml", "--out", "o"});
  }

  WorkFolder folder_;
};

TEST_F(Collect, ReadsAsTable) {
  const CampaignTable table = read_table(folder_ / "o" / "campaign.sqlite");
  ASSERT_EQ(table.runs.size(), 5u);
  EXPECT_EQ(table.planned, 5);
  EXPECT_THAT(table.inputs, ::testing::ElementsAre("x", "attitude.yaw", "attitude.pitch",
                                                   "attitude.roll", "spin.angle", "spin.azimuth"));
  EXPECT_THAT(table.measures, ::testing::Contains("peak_tension"));
  EXPECT_THAT(table.measures, Not(::testing::Contains("wall_time")));
  const CampaignRow& row = table.runs[2];
  EXPECT_EQ(row.id, 2);
  EXPECT_EQ(row.outcome, "finished");
  EXPECT_EQ(row.success, false);
  EXPECT_EQ(row.inputs.size(), table.inputs.size());
  EXPECT_EQ(row.measures.size(), table.measures.size());
  EXPECT_THAT(row.command, HasSubstr("campaign replay"));
}

TEST_F(Collect, EqualRowsOfTwoShardsCountOnce) {
  const std::string rows = testing::rows_of(folder_, "o");
  fs::copy_file(first_shard(folder_, "o"), folder_ / "o" / "shards" / "other.sqlite");
  EXPECT_EQ(collect_again().exit_code, 0);
  EXPECT_EQ(testing::rows_of(folder_, "o"), rows);
}

TEST_F(Collect, DifferentRowsOfOneRunAreRefusedByItsId) {
  const fs::path other = folder_ / "o" / "shards" / "other.sqlite";
  fs::copy_file(first_shard(folder_, "o"), other);
  Database(other).execute("UPDATE runs SET measures = '{}' WHERE id = 3");
  const ProcessResult result = collect_again();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("run 3 is recorded twice with different content"));
}

TEST_F(Collect, EmptyShardOfAKilledWorkerDoesNoHarm) {
  std::ofstream(folder_ / "o" / "shards" / "nothing.sqlite").flush();
  EXPECT_EQ(collect_again().exit_code, 0);
}

TEST_F(Collect, ShardThatIsNoDatabaseIsNamed) {
  std::ofstream(folder_ / "o" / "shards" / "torn.sqlite") << std::string(5000, 'x');
  const ProcessResult result = collect_again();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("torn.sqlite: file is not a database"));
}

TEST_F(Collect, ChangedCampaignOrMissionIsRefusedWithAnOldFolder) {
  const std::string campaign = folder_.read("c.toml"), mission = folder_.read("m.toml");
  folder_.write("c.toml", campaign + "# a comment changes nothing\n");
  EXPECT_EQ(folder_.run({"campaign", "run", "c.toml", "--out", "o"}).exit_code, 0);
  folder_.write("c.toml", testing::replaced(campaign, "low = -0.2", "low = -0.3"));
  for (const char* command : {"run", "resume", "status", "collect"}) {
    const ProcessResult result = folder_.run({"campaign", command, "c.toml", "--out", "o"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("holds results of another campaign: its file has changed"));
  }
  folder_.write("c.toml", campaign);
  folder_.write("m.toml", testing::replaced(mission, "radius = 0.2", "radius = 0.21"));
  EXPECT_THAT(folder_.run({"campaign", "run", "c.toml", "--out", "o"}).err,
              HasSubstr("holds results of another mission"));
}

TEST_F(Collect, CsvHoldsTheSameNumbers) {
  const ProcessResult result =
      folder_.run({"campaign", "collect", "c.toml", "--out", "o", "--csv", "t.csv"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string csv = folder_.read("t.csv");
  EXPECT_EQ(testing::line_count(csv), 6u);
  EXPECT_THAT(csv, ::testing::StartsWith("id,in_x,in_attitude.yaw,"));
  const auto line = csv.find("\r\n0,") + 4;
  const CampaignTable table = read_table(folder_ / "o" / "campaign.sqlite");
  EXPECT_EQ(std::stod(csv.substr(line)), table.runs[0].inputs[0]);
  // No spelling of a number that is none.
  EXPECT_THAT(csv, Not(HasSubstr("nan")));
  EXPECT_THAT(csv, Not(HasSubstr("inf")));
}

TEST_F(Collect, ReportIsOneFile) {
  const ProcessResult result = folder_.run({"campaign", "report", "c.toml", "--out", "o"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(folder_.read("o/campaign.html"), HasSubstr("</html>"));
}

TEST(Shard, NumbersReadBackToTheSameBitsAndNothingElseIsStored) {
  Measures measures = {{"a", "", 0.1 + 0.2},        {"b", "", std::int64_t{7}}, {"c", "", true},
                       {"d", "", std::monostate{}}, {"e", "", 5e-324},          {"f", "", 3.0}};
  const Measures back = measures_of(measures_text(measures));
  ASSERT_EQ(back.size(), measures.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].name, measures[i].name);
    EXPECT_EQ(back[i].value, measures[i].value) << back[i].name;
  }
  const std::vector<double> inputs = {1.0 / 3.0, -0.0, 1e300};
  EXPECT_EQ(inputs_of(inputs_text(inputs)), inputs);
}

}  // namespace
}  // namespace retiarius

// The same database from every engine, bit for bit.
#include <fstream>

#include <gmock/gmock.h>

#include "retiarius/campaign/shard.hpp"
#include "tests/campaign/small_campaign.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::monte_carlo;
using testing::ProcessResult;
using testing::rows_of;
using ::testing::StartsWith;
using testing::WorkFolder;

void run_well(const WorkFolder& folder, const std::vector<std::string>& arguments) {
  const ProcessResult result = folder.run(arguments);
  ASSERT_EQ(result.exit_code, 0) << result.err << result.out;
}

class EveryDesign : public ::testing::TestWithParam<const char*> {};

TEST_P(EveryDesign, IsEqualFromOneProcessTwoProcessesPiecesAndRanks) {
  const WorkFolder folder;
  testing::write_small_campaign(
      folder, std::string("design = \"") + GetParam() + "\"\nruns = 12\nseed = 3\n");
  run_well(folder, {"campaign", "run", "c.toml", "--jobs", "1", "--out", "one"});
  run_well(folder, {"campaign", "run", "c.toml", "--jobs", "2", "--out", "two"});
  // Pieces in another order, some of them twice.
  for (const char* ids : {"9-11", "4-10", "0-3"})
    run_well(folder, {"campaign", "run", "c.toml", "--jobs", "1", "--out", "pieces", "--ids", ids});
  run_well(folder, {"campaign", "resume", "c.toml", "--out", "pieces"});
  const std::string rows = rows_of(folder, "one");
  EXPECT_GE(testing::line_count(rows), 12u);
  EXPECT_EQ(rows_of(folder, "two"), rows);
  EXPECT_EQ(rows_of(folder, "pieces"), rows);
  if (!testing::has_mpi()) return;
  for (const int ranks : {2, 4}) {
    const std::string out = "ranks" + std::to_string(ranks);
    const ProcessResult result =
        testing::mpirun(folder, ranks, {"campaign", "run", "c.toml", "--out", out});
    ASSERT_EQ(result.exit_code, 0) << result.out;
    EXPECT_EQ(rows_of(folder, out), rows);
    EXPECT_EQ(testing::query(folder, out, "SELECT engine FROM timings"), "mpi");
  }
}

INSTANTIATE_TEST_SUITE_P(Designs, EveryDesign,
                         ::testing::Values("monte-carlo", "latin-hypercube", "sobol", "saltelli"));

TEST(Engines, MpiIsBuiltInOrSaidToBeMissing) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(2));
  EXPECT_THAT(folder.run({"--version"}).out, HasSubstr("MPI"));
  if (testing::has_mpi()) GTEST_SKIP() << "MPI is built in";
  const ProcessResult result = folder.run({"campaign", "run", "c.toml", "--engine", "mpi"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("built without MPI (CMake option RETIARIUS_MPI)"));
}

TEST(Engines, RunAgainDoesNothingTwice) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(6));
  run_well(folder, {"campaign", "run", "c.toml", "--out", "o"});
  const std::string rows = rows_of(folder, "o");
  const std::string started = testing::query(folder, "o",
                                             "SELECT group_concat(host || started || "
                                             "wall_time) FROM timings");
  run_well(folder, {"campaign", "run", "c.toml", "--out", "o"});
  EXPECT_EQ(rows_of(folder, "o"), rows);
  EXPECT_EQ(testing::query(folder, "o",
                           "SELECT group_concat(host || started || wall_time) FROM "
                           "timings"),
            started);
}

TEST(Engines, ReplayEqualsTheRecord) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(4));
  run_well(folder, {"campaign", "run", "c.toml", "--out", "o"});
  const ProcessResult result =
      folder.run({"campaign", "replay", "c.toml", "--id", "3", "--out", "o"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("equal to what is on record, bit for bit"));
  EXPECT_TRUE(folder.has("o/replays/3/report.html"));
  EXPECT_TRUE(folder.has("o/replays/3/run.h5"));
  EXPECT_EQ(folder.run({"campaign", "replay", "c.toml", "--id", "4", "--out", "o"}).exit_code, 2);
  const std::string command = testing::query(folder, "o", "SELECT command FROM runs WHERE id = 3");
  EXPECT_EQ(command, "retiarius campaign replay " +
                         std::filesystem::canonical(folder.path()).string() + "/c.toml --id 3");
}

// Of ten thousand tasks that each read what all others wrote, none would get to work.
TEST(Engines, PartsReadNoRowsOfOthers) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(9));
  const std::vector<std::string> run = {"campaign", "run",    "c.toml", "--out",
                                        "o",        "--jobs", "1",      "--ids"};
  const auto part = [&](const std::string& ids) {
    std::vector<std::string> arguments = run;
    arguments.push_back(ids);
    return folder.run(arguments);
  };
  ASSERT_EQ(part("0-4").exit_code, 0);
  const auto shards = find_shards(folder / "o");
  ASSERT_EQ(shards.size(), 1u);
  EXPECT_THAT(shards[0].filename().string(), StartsWith("ids-0-4-"));
  std::ofstream(shards[0]) << "no database, whatever its name may say";
  EXPECT_EQ(part("5-8").exit_code, 0);
  const ProcessResult both = part("4-5");
  EXPECT_NE(both.exit_code, 0);
  EXPECT_THAT(both.err, HasSubstr("ids-0-4-"));
}

TEST(Engines, SlurmJobIsAnArrayOfBatches) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(25));
  run_well(folder, {"campaign", "run", "c.toml", "--out", "o", "--engine", "slurm", "--batch", "10",
                    "--sbatch=--partition=long"});
  const std::string script = folder.read("o/slurm/job.sh");
  EXPECT_THAT(script, StartsWith("#!/bin/sh\n"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --array=0-2\n"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --requeue\n"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --partition=long\n"));
  // What Slurm would do, in another order.
  for (const char* task : {"2", "0", "1"}) {
    const std::string command = std::string("SLURM_ARRAY_TASK_ID=") + task + " sh '" +
                                (folder / "o/slurm/job.sh").string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }
  run_well(folder, {"campaign", "collect", "c.toml", "--out", "o"});
  run_well(folder, {"campaign", "run", "c.toml", "--out", "here"});
  EXPECT_EQ(rows_of(folder, "o"), rows_of(folder, "here"));
  EXPECT_EQ(testing::query(folder, "o", "SELECT engine FROM timings"), "slurm");
}

// The rule stops at the same run whoever works, though others were done beyond it.
TEST(Engines, StopRuleCutsAtTheSameRun) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(400), "[stop]\nwidth = 0.2\nbatch = 10\n");
  run_well(folder, {"campaign", "run", "c.toml", "--jobs", "1", "--out", "one"});
  run_well(folder, {"campaign", "run", "c.toml", "--jobs", "4", "--out", "four"});
  EXPECT_EQ(rows_of(folder, "one"), rows_of(folder, "four"));
  const std::string rows = testing::query(folder, "one", "SELECT count(*) FROM runs");
  EXPECT_EQ(rows, testing::query(folder, "one", "SELECT value FROM campaign WHERE key='planned'"));
  EXPECT_LT(std::stoi(rows), 100);
  EXPECT_EQ(std::stoi(rows) % 10, 0);
}

}  // namespace
}  // namespace retiarius

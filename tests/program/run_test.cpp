// What a run leaves behind and says.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "retiarius/mission/reader.hpp"
#include "retiarius/record/checkpoint.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::ContainsRegex;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using testing::line_count;
using testing::ProcessResult;
using testing::replaced;
using testing::small_mission;
using ::testing::StartsWith;
using testing::WorkFolder;

nlohmann::json summary_of(const WorkFolder& folder, const std::string& run) {
  return nlohmann::json::parse(folder.read(run + "/summary.json"));
}

TEST(Run, LeavesEveryResult) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result = folder.run({"run", "m.toml", "--out", "a/b"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  for (const char* name : {"history.csv", "frames.pvd", "frames", "run.h5", "checkpoint",
                           "summary.json", "resolved.toml", "report.html"})
    EXPECT_TRUE(folder.has(std::string("a/b/") + name)) << name;
  EXPECT_EQ(line_count(folder.read("a/b/history.csv")), 12u);  // header; t = 0, 0.02 ... 0.2 s
  const auto summary = summary_of(folder, "a/b");
  EXPECT_EQ(summary["outcome"], "finished");
  EXPECT_EQ(summary["measures"]["steps"], 20);
  EXPECT_GT(summary["measures"]["wall_time"], 0.0);
  EXPECT_DOUBLE_EQ(read_checkpoint(folder / "a/b").time, 0.2);
  EXPECT_EQ(read_mission((folder / "a/b/resolved.toml").string()).title, "A small net");
}

TEST(Run, SaysOnlyChoicesAndOutcomeWhereThereIsNoTerminal) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result = folder.run({"run", "m.toml"});
  EXPECT_EQ(result.err, "");
  EXPECT_THAT(result.out, StartsWith("free: solver reuse: all threads carry compression, "));
  EXPECT_THAT(result.out, HasSubstr("\nfinished: A small net\n  0.2 s simulated in "));
  EXPECT_THAT(result.out, ContainsRegex("\n  free +0 s +0.2 s +time >= 0.2\n"));
  EXPECT_THAT(result.out, ContainsRegex("\n  peak_tension +[0-9.]+ N\n"));
  EXPECT_THAT(result.out, ContainsRegex("\n  steps +20\n"));
  EXPECT_THAT(result.out, EndsWith("\nreport: out/m/report.html\n"));
  EXPECT_TRUE(folder.has("out/m/summary.json"));  // the default folder
}

TEST(Run, TellsWhatAutoTookWhereItIsLookedFor) {
  const WorkFolder folder;
  folder.write("m.toml",
               replaced(small_mission(), "[integrator]\n", "[integrator]\nmethod = \"auto\"\n"));
  const ProcessResult result = folder.run({"run", "m.toml", "--out", "r"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json summary = nlohmann::json::parse(folder.read("r/summary.json"));
  ASSERT_EQ(summary["chosen"].size(), 1u);
  const auto& chosen = summary["chosen"][0];
  EXPECT_EQ(chosen["phase"], "free");
  const std::string taken = chosen["integrator"]["taken"], why = chosen["integrator"]["reason"];
  EXPECT_TRUE(taken == "explicit" || taken == "implicit-euler") << taken;
  const std::string line = "free: integrator " + taken + ": " + why + "\n";
  EXPECT_THAT(summary["start_report"].get<std::string>(), HasSubstr(line));
  EXPECT_THAT(result.out, StartsWith(line));
  EXPECT_THAT(folder.run({"info", "m.toml"}).out, HasSubstr("\nchosen\n  " + line));
}

TEST(Run, QuietSaysNothing) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result = folder.run({"run", "m.toml", "--quiet"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_TRUE(folder.has("out/m/report.html"));
}

TEST(Run, OverridesReachTheResolvedMission) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result = folder.run(
      {"run", "--set", "phase[0].until=time >= 0.1", "--set", "net.thread.radius=0.004", "m.toml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Mission mission = read_mission((folder / "out/m/resolved.toml").string());
  EXPECT_EQ(mission.net.thread.radius, 0.004);
  EXPECT_EQ(summary_of(folder, "out/m")["measures"]["steps"], 10);
}

TEST(Run, StartsFromASavedState) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "first"}).exit_code, 0);
  const ProcessResult again = folder.run({"run", "m.toml", "--out", "second", "--start", "first"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  // Two runs of 0.2 s, the second from the first's end, and one of 0.4 s come to the same state;
  // time counts anew.
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "whole", "--set", "phase[0].until=time >= 0.4"})
                .exit_code,
            0);
  const State halves = read_checkpoint(folder / "second"),
              whole = read_checkpoint(folder / "whole");
  EXPECT_DOUBLE_EQ(halves.time, 0.2);
  ASSERT_EQ(halves.x.size(), whole.x.size());
  for (std::size_t i = 0; i < whole.x.size(); ++i)
    EXPECT_LT((halves.x[i] - whole.x[i]).norm(), 1e-9) << i;
  EXPECT_GT((whole.x[0] - read_checkpoint(folder / "first").x[0]).norm(), 1e-3);
}

TEST(Run, RefusesAStateOfAnotherNet) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "first"}).exit_code, 0);
  const ProcessResult result = folder.run(
      {"run", "m.toml", "--out", "second", "--start", "first", "--set", "net.segments=3"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("a state fits only the net that it was saved from"));
  EXPECT_FALSE(folder.has("second"));
}

TEST(Run, TakesTheNetsStateFromAnEarlierRun) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "first"}).exit_code, 0);
  const ProcessResult result =
      folder.run({"run", "m.toml", "--out", "second", "--set", "net.state=first", "--set",
                  "net.position=[0.0, 0.0, 7.0]", "--set", "phase[0].until=time >= 0.01", "--set",
                  "output.interval=0.01"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const State first = read_checkpoint(folder / "first"),
              second = read_checkpoint(folder / "second");
  for (std::size_t i = 0; i < first.x.size(); ++i)  // one step of 0.01 s at metres per second
    EXPECT_LT((second.x[i] - first.x[i] - Vec3(0, 0, 7)).norm(), 0.2) << i;
}

// Paths in a mission start from its folder, wherever the program is called.
TEST(Run, FindsTheNetworkFileBesideTheMission) {
  const WorkFolder folder;
  std::filesystem::create_directory(folder / "sub");
  folder.write("sub/net.txt",
               "node -1 0 0\nnode 0 0 0\nnode 1 0 0\nnode 0 1 0\nsegment 0 1\nsegment 1 2\n"
               "segment 1 3\nthread 0 1 2\n");
  folder.write(
      "sub/m.toml",
      replaced(small_mission(), "pattern = \"hexagon\"\nside = 1.0\nmesh = 0.5\nsegments = 2\n",
               "pattern = \"file\"\nfile = \"net.txt\"\n"));
  const ProcessResult result = folder.run({"run", "sub/m.toml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(folder.run({"info", "sub/m.toml"}).out, ContainsRegex("\n  nodes +4\n"));
  EXPECT_EQ(folder.run({"validate", "out/m/resolved.toml"}).exit_code, 0);
}

// A thread that carries more than its strength is an outcome of its own.
TEST(Run, BrokenThreadIsAnOutcomeWithExitCodeOne) {
  const WorkFolder folder;
  folder.write("m.toml",
               replaced(small_mission(), "radius = 0.01", "radius = 0.01\nstrength = 1.0"));
  const ProcessResult result = folder.run({"run", "m.toml"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("\nbroke: A small net\n  segment "));
  EXPECT_THAT(result.err, ContainsRegex("retiarius: warning: segment [0-9]+ carried"));
  EXPECT_EQ(summary_of(folder, "out/m")["outcome"], "broke");
}

// One Newton iteration cannot solve a step, and halving is forbidden.
TEST(Run, FailureIsToldWithWhatWasComputed) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result = folder.run({"run", "m.toml", "--set", "integrator.max_iterations=1",
                                           "--set", "integrator.max_halvings=0"});
  EXPECT_EQ(result.exit_code, 1) << result.out;
  EXPECT_THAT(result.err, StartsWith("retiarius: error: "));
  EXPECT_THAT(result.out, HasSubstr("\nfailed: A small net\n"));
  const auto summary = summary_of(folder, "out/m");
  EXPECT_EQ(summary["outcome"], "failed");
  EXPECT_NE(summary["reason"], "");
  EXPECT_GE(line_count(folder.read("out/m/history.csv")), 2u);
  EXPECT_TRUE(folder.has("out/m/report.html"));
}

TEST(Run, StarterMissionRunsAsItIs) {
  const WorkFolder folder;
  ASSERT_EQ(folder.run({"new", "first"}).exit_code, 0);
  const ProcessResult result = folder.run({"run", "first.toml"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(summary_of(folder, "out/first")["phases"].size(), 3u);
}

}  // namespace
}  // namespace retiarius

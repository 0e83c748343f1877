#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::replaced;
using testing::small_mission;
using testing::WorkFolder;

TEST(ConvergeCommand, TellsTheCostThenWhatHoldsAndLeavesAPage) {
  const WorkFolder folder;
  folder.write("small.toml", small_mission());
  const ProcessResult result = folder.run({"converge", "small.toml", "--out", "c"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("5 runs; together they cost about 14.2 times the mission"));
  EXPECT_THAT(result.out, HasSubstr("finer time step:"));
  EXPECT_THAT(result.out, HasSubstr("finer mesh:"));
  EXPECT_LT(result.out.find("5 runs"), result.out.find("running as given"));
  EXPECT_EQ(folder.listing(), "c small.toml");
  EXPECT_THAT(folder.read("c/converge.html"), HasSubstr("Peak tension"));
  const auto json = nlohmann::json::parse(folder.read("c/converge.json"));
  EXPECT_EQ(json["levels"].size(), 5u);
}

TEST(ConvergeCommand, VariesWhatItIsAskedTo) {
  const WorkFolder folder;
  folder.write("small.toml", small_mission());
  const ProcessResult result =
      folder.run({"converge", "small.toml", "--vary", "step", "--levels", "2", "--tolerance", "0.5",
                  "--set", "integrator.step=0.005", "--out", "c"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("2 runs"));
  EXPECT_THAT(result.out, HasSubstr("h = 0.0025 s"));
  EXPECT_THAT(result.out, HasSubstr("hold at 50 %, 0 do not"));
}

// With few iterations and no halvings the finer meshes fail; how many of four depends on the limit.
ProcessResult run_with_few_iterations(const WorkFolder& folder, int iterations,
                                      const std::string& out) {
  folder.write("small.toml", small_mission());
  return folder.run({"converge", "small.toml", "--vary", "mesh", "--levels", "4", "--set",
                     "integrator.max_halvings=0", "--set",
                     "integrator.max_iterations=" + std::to_string(iterations), "--out", out});
}

TEST(ConvergeCommand, GoesOnAfterALevelThatFails) {
  const WorkFolder folder;
  ProcessResult result;
  int iterations = 2;
  do {
    result = run_with_few_iterations(folder, iterations, std::to_string(iterations));
  } while (result.exit_code != 0 && ++iterations < 30);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("4 segments a piece: finished in"));
  EXPECT_THAT(result.out, HasSubstr("16 segments a piece: failed in"));
  EXPECT_THAT(result.out, HasSubstr("does not converge"));
}

TEST(ConvergeCommand, FailsWhereNoTwoLevelsCanBeCompared) {
  const WorkFolder folder;
  const ProcessResult result = run_with_few_iterations(folder, 2, "c");
  EXPECT_EQ(result.exit_code, 1) << result.out;
  EXPECT_TRUE(folder.has("c/converge.html"));
}

TEST(ConvergeCommand, KeepsWhatWasComputedWhenInterrupted) {
  const WorkFolder folder;
  folder.write("endless.toml", testing::endless_mission());
  testing::Process process({"converge", "endless.toml", "--vary", "step", "--out", "c"},
                           folder.path());
  for (int k = 0; k < 500 && !folder.has("c"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  process.send(SIGINT);
  const ProcessResult result = process.wait();
  EXPECT_EQ(result.exit_code, 4) << result.err;
  const auto json = nlohmann::json::parse(folder.read("c/converge.json"));
  EXPECT_EQ(json["interrupted"], true);
  EXPECT_EQ(json["levels"][1]["reason"], "not begun");
}

TEST(ConvergeCommand, RefusesWrongInputAndWritesNothing) {
  const WorkFolder folder;
  folder.write("small.toml",
               replaced(small_mission(), "[integrator]", "[integrator]\nmethod = \"static\""));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"converge", "small.toml", "--vary", "step", "--out", "c"},
        {"converge", "small.toml", "--levels", "1", "--out", "c"},
        {"converge", "small.toml", "--vary", "time", "--out", "c"},
        {"converge", "small.toml", "--set", "net.mesh=0.3", "--out", "c"}}) {
    const ProcessResult result = folder.run(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_EQ(folder.listing(), "small.toml");
  }
}

}  // namespace
}  // namespace retiarius

// Runs that are killed or stopped and resumed, as a user would.
#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::line_count;
using testing::Process;
using testing::ProcessResult;
using testing::replaced;
using testing::WorkFolder;

// Half a second of computing or more, with a body to fall on.
std::string long_mission() {
  return replaced(testing::small_mission(), "time >= 0.2", "time >= 12.0") + R"(
[target]
shape = "sphere"
radius = 0.3
motion = "fixed"
position = [0.0, 0.0, -0.4]

[contact]
method = "modified-mass"
friction = 0.3
)";
}

nlohmann::json summary_in(const WorkFolder& folder, const std::string& out) {
  auto summary = nlohmann::json::parse(folder.read(out + "/summary.json"));
  summary.erase("timings");
  summary["measures"].erase("wall_time");
  return summary;
}

void expect_same(const WorkFolder& folder, const std::string& one, const std::string& other) {
  for (const char* name : {"history.csv", "replay.bin", "checkpoint", "frames.pvd"})
    EXPECT_TRUE(folder.read(one + "/" + name) == folder.read(other + "/" + name)) << name;
  EXPECT_EQ(summary_in(folder, one), summary_in(folder, other));
}

// Sends the signal once so many rows are written; false where the run was over before.
bool break_at(Process& process, const WorkFolder& folder, std::size_t rows, int signal) {
  while (process.running()) {
    if (folder.has("broken/history.csv") && line_count(folder.read("broken/history.csv")) > rows) {
      process.send(signal);
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

class ResumeAfter : public ::testing::TestWithParam<int> {};

TEST_P(ResumeAfter, TheFolderIsThatOfAWholeRun) {
  const WorkFolder folder;
  folder.write("m.toml", long_mission());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "whole", "--quiet"}).exit_code, 0);
  int breaks = 0;
  std::vector<std::string> arguments{"run", "m.toml", "--out", "broken"};
  for (std::size_t rows : {50, 120, 260}) {
    Process process(arguments, folder.path());
    breaks += break_at(process, folder, rows, GetParam()) ? 1 : 0;
    const ProcessResult result = process.wait();
    if (GetParam() == SIGKILL) {
      EXPECT_EQ(result.signal, SIGKILL);
    } else {
      EXPECT_EQ(result.exit_code, 4) << result.err;
      EXPECT_THAT(result.out, HasSubstr("retiarius resume broken"));
    }
    arguments = {"resume", "broken"};
  }
  EXPECT_EQ(breaks, 3);
  const ProcessResult last = folder.run(arguments);
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_THAT(last.out, HasSubstr("finished: A small net"));
  expect_same(folder, "whole", "broken");
  EXPECT_TRUE(folder.has("broken/report.html"));

  const ProcessResult again = folder.run(arguments);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.out, "broken: the run has finished; there is nothing to resume\n");
}

INSTANTIATE_TEST_SUITE_P(Signals, ResumeAfter, ::testing::Values(SIGKILL, SIGTERM, SIGUSR1),
                         [](const auto& instance) {
                           return instance.param == SIGKILL   ? "SIGKILL"
                                  : instance.param == SIGTERM ? "SIGTERM"
                                                              : "SIGUSR1";
                         });

// A run that was stopped soon after its start.
void run_a_little(const WorkFolder& folder, const std::vector<std::string>& more = {}) {
  folder.write("m.toml", long_mission());
  std::vector<std::string> arguments{"run", "m.toml", "--out", "broken", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Process process(arguments, folder.path());
  ASSERT_TRUE(break_at(process, folder, 20, SIGTERM));
  ASSERT_EQ(process.wait().exit_code, 4);
}

TEST(Resume, TakesTheKernelsThatTheRunWasBegunWith) {
  const WorkFolder folder;
  run_a_little(folder, {"--kernels", "portable"});
  ASSERT_EQ(folder.run({"resume", "broken", "--threads", "1"}).exit_code, 0);
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "whole", "--kernels", "portable"}).exit_code, 0);
  EXPECT_EQ(summary_in(folder, "broken")["kernels"], "portable");
  expect_same(folder, "whole", "broken");
}

TEST(Resume, RefusesWhatItCannotGoOnWith) {
  const WorkFolder folder;
  run_a_little(folder);
  const std::string history = folder.read("broken/history.csv");
  const std::string mission = folder.read("broken/resolved.toml");
  folder.write("broken/resolved.toml", mission + "\n");
  const ProcessResult changed = folder.run({"resume", "broken"});
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_THAT(changed.err, HasSubstr("its resolved.toml is not the mission"));
  folder.write("broken/resolved.toml", mission);

  for (const char* name : {"checkpoint", "checkpoint.previous"})
    folder.write(std::string("broken/") + name, "torn");
  const ProcessResult torn = folder.run({"resume", "broken"});
  EXPECT_EQ(torn.exit_code, 2);
  EXPECT_THAT(torn.err, HasSubstr("broken/checkpoint: it is not a checkpoint"));
  EXPECT_EQ(folder.read("broken/history.csv"), history);  // nothing was written

  EXPECT_EQ(folder.run({"resume", "m.toml"}).exit_code, 2);
  EXPECT_EQ(folder.run({"resume", "nowhere"}).exit_code, 2);
}

TEST(Resume, RefusesARunThatGoesOn) {
  const WorkFolder folder;
  folder.write("m.toml", testing::endless_mission());
  Process process({"run", "m.toml", "--out", "broken", "--quiet"}, folder.path());
  while (!folder.has("broken/checkpoint.previous") && process.running())
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const ProcessResult second = folder.run({"resume", "broken"});
  process.send(SIGKILL);
  process.wait();
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_THAT(second.err, HasSubstr("another process is writing the run in broken"));
}

// A run that failed for want of room goes on when there is some.
TEST(Resume, GoesOnAfterAFullDisk) {
  const WorkFolder folder;
  folder.write("m.toml", long_mission());
  testing::ProcessOptions options;
  options.file_size = 400'000;
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "broken"}, options).exit_code, 1);
  const ProcessResult result = folder.run({"resume", "broken"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "whole"}).exit_code, 0);
  expect_same(folder, "whole", "broken");
}

}  // namespace
}  // namespace retiarius

// A run that is stopped in the middle keeps what it computed.
#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "retiarius/record/checkpoint.hpp"
#include "retiarius/record/run_file.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using testing::endless_mission;
using ::testing::HasSubstr;
using testing::line_count;
using testing::Process;
using testing::ProcessResult;
using testing::WorkFolder;

// Waits until the run has written so many rows.
bool wait_for_rows(Process& process, const WorkFolder& folder, std::size_t rows) {
  for (int k = 0; k < 2000 && process.running(); ++k) {
    if (line_count(folder.read("out/m/history.csv")) > rows) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

class Interruption : public ::testing::TestWithParam<int> {};

TEST_P(Interruption, KeepsWhatWasComputed) {
  const WorkFolder folder;
  folder.write("m.toml", endless_mission());
  Process process({"run", "m.toml"}, folder.path());
  ASSERT_TRUE(wait_for_rows(process, folder, 10)) << process.wait().err;
  process.send(GetParam());
  const ProcessResult result = process.wait();
  EXPECT_EQ(result.exit_code, 4) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\ninterrupted: A small net\n"));

  const std::string history = folder.read("out/m/history.csv");
  EXPECT_GT(line_count(history), 10u);
  EXPECT_EQ(history.back(), '\n');
  const auto summary = nlohmann::json::parse(folder.read("out/m/summary.json"));
  EXPECT_EQ(summary["outcome"], "interrupted");
  EXPECT_GT(summary["measures"]["steps"], 10);
  EXPECT_GT(read_checkpoint(folder / "out/m").time, 0.1);
  EXPECT_GT(RunFile(folder / "out/m/run.h5").frame_count(), 1u);
  EXPECT_TRUE(folder.has("out/m/report.html"));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interruption, ::testing::Values(SIGINT, SIGTERM, SIGUSR1),
                         [](const auto& instance) {
                           return instance.param == SIGINT    ? "SIGINT"
                                  : instance.param == SIGTERM ? "SIGTERM"
                                                              : "SIGUSR1";
                         });

TEST(Killing, LeavesReadableFiles) {
  const WorkFolder folder;
  folder.write("m.toml", endless_mission());
  Process process({"run", "m.toml"}, folder.path());
  ASSERT_TRUE(wait_for_rows(process, folder, 30)) << process.wait().err;
  process.send(SIGKILL);
  EXPECT_EQ(process.wait().signal, SIGKILL);
  EXPECT_GT(line_count(folder.read("out/m/history.csv")), 30u);
  EXPECT_GT(RunFile(folder / "out/m/run.h5").frame_count(), 1u);
  EXPECT_EQ(folder.run({"export", "out/m", "--to", "csv", "--out", "tables"}).exit_code, 0);
}

// The first Ctrl-C waits for the end of a step, which is long for a large net; the second does not.
TEST(Killing, SecondInterruptEndsAtOnce) {
  const WorkFolder folder;
  folder.write("m.toml", endless_mission());
  Process process({"run", "m.toml", "--set", "net.pattern=square", "--set", "net.mesh=0.005",
                   "--set", "net.segments=1"},
                  folder.path());
  ASSERT_TRUE(wait_for_rows(process, folder, 1)) << process.wait().err;
  // Two that arrive before the process has a turn are one: on a busy machine a third is needed.
  for (int k = 0; k < 3; ++k) {
    process.send(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_EQ(process.wait().signal, SIGINT);
}

}  // namespace
}  // namespace retiarius

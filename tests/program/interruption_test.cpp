// A run that is stopped in the middle keeps what it computed.
#include <cmath>
#include <csignal>
#include <fstream>
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

// Waits until the program takes SIGTERM instead of ending by it.
void wait_until_ready(const Process& process) {
  constexpr unsigned long kTermination = 1ul << (SIGTERM - 1);
  const std::string name = "/proc/" + std::to_string(process.id()) + "/status";
  for (int k = 0; k < 5000; ++k) {
    std::ifstream file(name);
    for (std::string line; std::getline(file, line);)
      if (line.rfind("SigCgt:", 0) == 0 && (std::stoul(line.substr(7), nullptr, 16) & kTermination))
        return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  FAIL() << "the program does not take SIGTERM";
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

// Nothing is written for a long time, but steps end.
TEST(Interruption, NeedNotWaitForOutput) {
  for (const char* adaptive : {"true", "false"}) {
    const WorkFolder folder;
    folder.write("m.toml", endless_mission());
    Process process(
        {"run", "m.toml", "--set", "output.interval=50.0", "--set", "output.frame_interval=50.0",
         "--set", std::string("integrator.adaptive=") + adaptive},
        folder.path());
    while (!folder.has("out/m/checkpoint") && process.running())
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    process.send(SIGTERM);
    const ProcessResult result = process.wait();
    EXPECT_EQ(result.exit_code, 4) << result.err;
    const double time = read_checkpoint(folder / "out/m").time;
    EXPECT_GT(time, 0.0);
    EXPECT_GT(std::abs(std::remainder(time, 50.0)), 1e-3);
  }
}

// The order of elimination is found by METIS, which takes SIGTERM for a failure of its own; several
// threads are there, of which any may get the signal.
TEST(Interruption, DoesNotDisturbTheOrderOfElimination) {
  const WorkFolder folder;
  folder.write("m.toml", endless_mission());
  for (int k = 0; k < 8; ++k) {
    const std::string out = "out" + std::to_string(k);
    Process process({"run", "m.toml", "--out", out, "--threads", "2", "--set", "net.mesh=0.02",
                     "--set", "net.segments=2"},
                    folder.path());
    wait_until_ready(process);
    std::this_thread::sleep_for(std::chrono::milliseconds(20 * k));
    process.send(SIGTERM);
    const ProcessResult result = process.wait();
    EXPECT_EQ(result.exit_code, 4) << k << result.err;
  }
}

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

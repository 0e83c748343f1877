// Thirty random kills of workers and coordinators: nothing is lost, nothing counted twice, and the
// rows are those of an undisturbed campaign.
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include <gmock/gmock.h>

#include "tests/campaign/small_campaign.hpp"

namespace retiarius {
namespace {

using testing::Process;
using testing::WorkFolder;

constexpr int kKills = 30;

// Kills a worker or, every third time, the coordinator, after a random while. False where all runs
// were done before.
bool kill_somebody(Process& process, std::mt19937& random, int kill) {
  const auto wait = std::chrono::milliseconds(30 + random() % 100);
  std::this_thread::sleep_for(wait);
  if (!process.running()) return false;
  const std::vector<pid_t> workers = testing::children_of(process.id());
  if (kill % 3 == 0 || workers.empty()) {
    process.send(SIGKILL);
    return true;
  }
  return ::kill(workers[random() % workers.size()], SIGKILL) == 0;
}

TEST(Kills, NothingIsLostNothingIsCountedTwice) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, testing::monte_carlo(3000), "[limits]\nattempts = 1000\n");
  const auto whole = folder.run({"campaign", "run", "c.toml", "--jobs", "2", "--out", "whole"});
  ASSERT_EQ(whole.exit_code, 0) << whole.err;
  std::mt19937 random(7);
  int kills = 0;
  bool over = false;
  while (!over && kills < kKills) {
    Process process({"campaign", "run", "c.toml", "--jobs", "2", "--out", "o"}, folder.path());
    while (kills < kKills && process.running()) {
      if (!kill_somebody(process, random, kills)) break;
      ++kills;
      if (kills % 3 == 1) break;  // the coordinator is dead
    }
    if (kills >= kKills && process.running()) process.send(SIGKILL);
    const testing::ProcessResult result = process.wait();
    over = result.exit_code == 0;
    if (!over) {
      ASSERT_EQ(result.signal, SIGKILL) << result.err;
    }
  }
  EXPECT_EQ(kills, kKills) << "the campaign was over too soon";
  const auto last = folder.run({"campaign", "resume", "c.toml", "--jobs", "2", "--out", "o"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(testing::query(folder, "o", "SELECT count(*) FROM runs"), "3000");
  EXPECT_TRUE(testing::rows_of(folder, "o") == testing::rows_of(folder, "whole"));
}

}  // namespace
}  // namespace retiarius

// Runs that go wrong are recorded and the others go on; a place that takes no more ends the work
// with everything that is done intact.
#include <chrono>
#include <csignal>
#include <fstream>
#include <optional>
#include <thread>

#include <gmock/gmock.h>

#include "retiarius/campaign/process_engine.hpp"
#include "tests/campaign/small_campaign.hpp"

namespace retiarius {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using testing::monte_carlo;
using testing::Process;
using testing::ProcessResult;
using testing::query;
using testing::WorkFolder;

// A mission whose runs go on for ever.
void make_endless(const WorkFolder& folder) {
  const std::string floating = testing::replaced(folder.read("m.toml"), "-50.0", "0.0");
  folder.write("m.toml", testing::replaced(floating, "time >= 0.05", "time >= 1e6"));
}

// A list of one variable, in place of the small campaign's.
void write_list(const WorkFolder& folder, const std::string& path, const std::string& values,
                const std::string& more = "") {
  testing::write_small_campaign(folder, monte_carlo(1));
  folder.write("c.toml",
               "mission = \"m.toml\"\n[plan]\ndesign = \"list\"\n[[variable]]\nname = "
               "\"v\"\nset = \"" +
                   path + "\"\ndistribution = \"values\"\nvalues = " + values + "\n" + more);
}

TEST(Failures, ImpossibleInputsAreRecordedWithReasonAndCommand) {
  const WorkFolder folder;
  write_list(folder, "net.thread.radius", "[0.01, -1, 0.02]");
  const ProcessResult run = folder.run({"campaign", "run", "c.toml", "--out", "o"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(query(folder, "o", "SELECT group_concat(outcome) FROM runs"),
            "finished,refused,finished");
  EXPECT_THAT(query(folder, "o", "SELECT reason FROM runs WHERE id = 1"),
              HasSubstr("net.thread.radius = -1: must be greater than 0"));
  EXPECT_EQ(query(folder, "o", "SELECT peak_tension IS NULL FROM runs WHERE id = 1"), "1");
  const ProcessResult again =
      folder.run({"campaign", "replay", "c.toml", "--id", "1", "--out", "o"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("run 1: refused"));
}

TEST(Failures, BadMeshIsRecorded) {
  const WorkFolder folder;
  write_list(folder, "target.scale", "[1, 2]");
  std::string mission = folder.read("m.toml");
  mission = testing::replaced(mission, "shape = \"sphere\"\nradius = 0.2",
                              "shape = \"mesh\"\nfile = \"open.obj\"");
  folder.write("m.toml", mission);
  folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const ProcessResult run = folder.run({"campaign", "run", "c.toml", "--out", "o"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(query(folder, "o", "SELECT group_concat(outcome) FROM runs"), "refused,refused");
  EXPECT_THAT(query(folder, "o", "SELECT reason FROM runs"), HasSubstr("open.obj"));
}

TEST(Failures, DivergedRunIsRecorded) {
  const WorkFolder folder;
  // One iteration and no halving do not find the balance.
  write_list(folder, "integrator.max_iterations", "[100, 1]");
  folder.write("m.toml", testing::replaced(folder.read("m.toml"), "step = 0.01",
                                           "step = 0.01\nmax_halvings = 0"));
  const ProcessResult run = folder.run({"campaign", "run", "c.toml", "--out", "o"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(query(folder, "o", "SELECT outcome FROM runs WHERE id = 1"), "failed");
  EXPECT_NE(query(folder, "o", "SELECT reason FROM runs WHERE id = 1"), "");
  EXPECT_EQ(query(folder, "o", "SELECT success IS NULL FROM runs WHERE id = 1"), "1");
}

TEST(Failures, TimeoutIsRecordedWithoutWhatDependsOnTheMachine) {
  const WorkFolder folder;
  write_list(folder, "integrator.step", "[0.01]", "[limits]\nwall_clock = 0.3\n");
  make_endless(folder);
  const ProcessResult run = folder.run({"campaign", "run", "c.toml", "--out", "o"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(query(folder, "o", "SELECT outcome || ': ' || reason FROM runs"),
            "timeout: it reached the limit of 0.3 s of wall clock");
}

// The only worker is killed as often as there are attempts, while its run goes on for ever.
TEST(Failures, RunWhoseProcessDiesIsRecordedAsKilled) {
  const WorkFolder folder;
  write_list(folder, "integrator.step", "[0.01, 0.005]", "[limits]\nattempts = 2\n");
  make_endless(folder);
  Process process({"campaign", "run", "c.toml", "--jobs", "1", "--out", "o"}, folder.path());
  for (int wait = 0; wait < 40 && process.running(); ++wait) {
    std::this_thread::sleep_for(300ms + wait * 100ms);  // on a busy machine it takes long to begin
    // One that has not begun yet may be hit too; that is no attempt.
    for (const pid_t child : testing::children_of(process.id())) ::kill(child, SIGKILL);
  }
  const ProcessResult result = process.wait();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(query(folder, "o", "SELECT count(*) FROM runs WHERE outcome = 'killed'"), "2");
  EXPECT_THAT(query(folder, "o", "SELECT reason FROM runs"),
              HasSubstr("its process died in each of 2 attempts, the last time by signal 9"));
}

// As a coordinator that was killed while it started a worker leaves it held for a moment.
TEST(Failures, LockThatIsAboutToBeLeftIsWaitedFor) {
  const WorkFolder folder;
  std::optional<CampaignLock> first(std::in_place, folder.path());
  std::thread leaves([&first] {
    std::this_thread::sleep_for(200ms);
    first.reset();
  });
  EXPECT_NO_THROW(CampaignLock{folder.path()});
  leaves.join();
}

TEST(Failures, SecondCoordinatorIsRefused) {
  const WorkFolder folder;
  write_list(folder, "integrator.step", "[0.01]");
  make_endless(folder);
  Process first({"campaign", "run", "c.toml", "--jobs", "1", "--out", "o"}, folder.path());
  for (int wait = 0; wait < 200 && testing::children_of(first.id()).empty(); ++wait)
    std::this_thread::sleep_for(50ms);
  const ProcessResult second = folder.run({"campaign", "run", "c.toml", "--out", "o"});
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_THAT(second.err, HasSubstr("is at work on this campaign"));
  first.send(SIGTERM);
  const ProcessResult ended = first.wait();
  EXPECT_EQ(ended.exit_code, 4) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("resume"));
}

TEST(FullDisk, EndsClearlyAndGoesOnWhereItWas) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(60));
  testing::ProcessOptions options;
  options.file_size = 40'000;
  const ProcessResult full =
      folder.run({"campaign", "run", "c.toml", "--jobs", "1", "--out", "o"}, options);
  EXPECT_EQ(full.signal, 0);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, ::testing::AllOf(HasSubstr("o/shards/"), HasSubstr("disk")));
  const ProcessResult some = folder.run({"campaign", "collect", "c.toml", "--out", "o"});
  EXPECT_EQ(some.exit_code, 0) << some.err;
  const int done = std::stoi(query(folder, "o", "SELECT count(*) FROM runs"));
  EXPECT_GT(done, 5);
  EXPECT_LT(done, 60);
  EXPECT_EQ(folder.run({"campaign", "resume", "c.toml", "--out", "o"}).exit_code, 0);
  EXPECT_EQ(folder.run({"campaign", "run", "c.toml", "--out", "whole"}).exit_code, 0);
  EXPECT_EQ(testing::rows_of(folder, "o"), testing::rows_of(folder, "whole"));
}

// A kept run that finds no room is not the run's failure.
TEST(FullDisk, IsNoFailureOfARunWhoseResultsAreKept) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(3), "[keep]\nwhat = \"all\"\n");
  testing::ProcessOptions options;
  options.file_size = 60'000;
  const ProcessResult full =
      folder.run({"campaign", "run", "c.toml", "--jobs", "1", "--out", "o"}, options);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, HasSubstr("o/runs/0.part"));
  EXPECT_EQ(folder.run({"campaign", "resume", "c.toml", "--out", "o"}).exit_code, 0);
  EXPECT_EQ(query(folder, "o", "SELECT count(*) FROM runs WHERE outcome = 'finished'"), "3");
}

TEST(Status, TellsHowFarItIs) {
  const WorkFolder folder;
  testing::write_small_campaign(folder, monte_carlo(6));
  EXPECT_EQ(folder.run({"campaign", "resume", "c.toml", "--out", "o"}).exit_code, 2);
  EXPECT_EQ(folder.run({"campaign", "run", "c.toml", "--ids", "0-3", "--out", "o"}).exit_code, 0);
  const ProcessResult status = folder.run({"campaign", "status", "c.toml", "--out", "o"});
  EXPECT_EQ(status.exit_code, 0);
  EXPECT_THAT(status.out, HasSubstr("4 of 6 done"));
  EXPECT_EQ(folder.run({"campaign", "run", "c.toml", "--ids", "3-6", "--out", "o"}).exit_code, 2);
  EXPECT_EQ(folder.run({"campaign", "run", "c.toml", "--ids", "x", "--out", "o"}).exit_code, 2);
}

TEST(Plan, ReadyCampaignsFitTheirMissions) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(RETIARIUS_SOURCE_DIR "/missions/campaigns")) {
    const std::string text = [&] {
      std::ifstream file(entry.path());
      return std::string(std::istreambuf_iterator<char>(file), {});
    }();
    if (text.find("[plan]") == std::string::npos) continue;
    const ProcessResult result = WorkFolder().run({"campaign", "plan", entry.path().string()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    ++count;
  }
  EXPECT_GE(count, 1);
}

TEST(Plan, UnknownPathIsRefusedAtItsPlace) {
  const WorkFolder folder;
  write_list(folder, "net.thread.radus", "[1]");
  const ProcessResult result = folder.run({"campaign", "plan", "c.toml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("c.toml:4:1: variable[0].set = \"net.thread.radus\": unknown "
                                    "key net.thread.radus, did you mean radius?"));
}

}  // namespace
}  // namespace retiarius

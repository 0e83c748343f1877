// A run whose observer fails comes to its end all the same.
#include <gmock/gmock.h>

#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using testing::small_mission;

// Cannot write rows after the first `good` ones, and no frames either from then on.
class FullDisk : public Observer {
 public:
  explicit FullDisk(int good) : good_(good) {}

  void history(const HistoryRow&) override {
    if (rows++ >= good_) throw RunError("disk full at row " + std::to_string(rows));
  }
  void frame(const Frame&) override {
    if (rows <= good_) return;
    ++frames_refused;
    throw RunError("disk full at a frame");
  }
  void save(const Checkpoint& saved, bool) override {
    EXPECT_LE(saved.rows, good_);
    EXPECT_FALSE(saved.ended);
  }
  void end(const RunReport& told) override { report = told; }

  int rows = 0, frames_refused = 0;
  std::optional<RunReport> report;

 private:
  int good_;
};

RunReport run_with(FullDisk& observer) {
  const Mission mission = parse_mission(small_mission());
  return run_mission(mission, MissionModel(mission), observer);
}

TEST(RunFailure, FirstFailureIsTheReasonAndTheEndIsTold) {
  FullDisk observer(3);
  const RunReport report = run_with(observer);
  EXPECT_EQ(report.outcome, Outcome::failed);
  EXPECT_EQ(report.reason, "disk full at row 4");
  EXPECT_GT(observer.frames_refused, 0);  // an error of its own, which changes nothing
  ASSERT_EQ(report.phases.size(), 1u);
  EXPECT_EQ(report.phases[0].trigger, "failed");
  ASSERT_TRUE(observer.report.has_value());
  EXPECT_EQ(observer.report->reason, report.reason);
}

TEST(RunFailure, OneAtTheVeryStartIsAFailureToo) {
  FullDisk observer(0);
  EXPECT_EQ(run_with(observer).reason, "disk full at row 1");
  EXPECT_TRUE(observer.report.has_value());
}

TEST(CheckRun, FindsWhatTheRunWouldRefuse) {
  const Mission good = parse_mission(small_mission());
  EXPECT_NO_THROW(check_run(good, MissionModel(good)));
  const Mission bad = parse_mission(small_mission(), "m", ".", {"probe[0].node=corners"});
  EXPECT_THROW(check_run(bad, MissionModel(bad)), InputError);
  const Mission started = parse_mission(small_mission(), "m", ".", {"net.state=\".\""});
  EXPECT_THROW(check_run(started, MissionModel(started)), InputError);  // no state was given
}

}  // namespace
}  // namespace retiarius

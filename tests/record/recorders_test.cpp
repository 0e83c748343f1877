#include "retiarius/record/recorders.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/checkpoint.hpp"
#include "retiarius/record/file.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::error_text;
using ::testing::HasSubstr;
using testing::SampleRun;
using testing::TemporaryFolder;

RecordOptions options() {
  RecordOptions o;
  o.resolved = "title = \"resolved\"\n";
  return o;
}

TEST(MakeRecorders, LeaveEveryFileOfARun) {
  TemporaryFolder base;
  const SampleRun run;
  const auto recorders = make_recorders(base / "out", options());
  EXPECT_EQ(read_whole_file(base / "out/resolved.toml"), options().resolved);
  run.feed(*recorders, 3);
  recorders->end(run.report());
  for (const char* name : {"history.csv", "frames.pvd", "frames/frame_000001.vtp", "run.h5",
                           "checkpoint", "checkpoint.previous", "summary.json", "resolved.toml"})
    EXPECT_TRUE(std::filesystem::is_regular_file(base / "out" / name)) << name;
  EXPECT_EQ(read_checkpoint(base / "out").time, 0.1 * 2);
}

TEST(MakeRecorders, RefuseTheFolderOfAnEarlierRunUnlessTold) {
  TemporaryFolder base;
  make_recorders(base / "out", options());
  EXPECT_THAT(error_text<InputError>([&] { make_recorders(base / "out", options()); }),
              HasSubstr("exists and is not empty"));
  RecordOptions again = options();
  again.overwrite = true;
  again.vtk = false;
  const SampleRun run;
  run.feed(*make_recorders(base / "out", again), 1);
  EXPECT_FALSE(std::filesystem::exists(base / "out/frames.pvd"));
}

class Counter : public Observer {
 public:
  Counter(int* count, bool throws) : count_(count), throws_(throws) {}
  void progress(const State&, Index, double) override { ++*count_; }
  void end(const RunReport&) override {
    ++*count_;
    if (throws_) throw RunError("disk " + std::to_string(*count_));
  }

 private:
  int* count_;
  bool throws_;
};

TEST(FanOut, TellsAllOfTheEndAndPassesTheFirstErrorOn) {
  int count = 0;
  FanOut all;
  all.add(std::make_unique<Counter>(&count, true));
  all.add(std::make_unique<Counter>(&count, true));
  all.add(std::make_unique<Counter>(&count, false));
  all.progress(State{}, 0, 0.5);
  EXPECT_EQ(count, 3);
  EXPECT_EQ(error_text<RunError>([&] { all.end(RunReport{}); }), "disk 4");
  EXPECT_EQ(count, 6);
}

// Throws on every row.
class FullDisk : public Observer {
 public:
  explicit FullDisk(int* told) : told_(told) {}
  void history(const HistoryRow&) override { ++*told_, throw RunError("disk full"); }

 private:
  int* told_;
};

class RowCounter : public Observer {
 public:
  explicit RowCounter(int* rows) : rows_(rows) {}
  void history(const HistoryRow&) override { ++*rows_; }

 private:
  int* rows_;
};

TEST(FanOut, LetsOthersWriteOnAfterAnErrorThatItPassesOnOnce) {
  int told = 0, rows = 0;
  FanOut all;
  all.add(std::make_unique<FullDisk>(&told));
  all.add(std::make_unique<RowCounter>(&rows));
  EXPECT_EQ(error_text<RunError>([&] { all.history(HistoryRow{}); }), "disk full");
  EXPECT_NO_THROW(all.history(HistoryRow{}));
  EXPECT_EQ(told, 1);
  EXPECT_EQ(rows, 2);
}

}  // namespace
}  // namespace retiarius

#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::small_mission;
using testing::WorkFolder;

class Export : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("m.toml", small_mission());
    ASSERT_EQ(folder_.run({"run", "m.toml", "--out", "run"}).exit_code, 0);
  }

  WorkFolder folder_;
};

TEST_F(Export, CsvHoldsTheHistoryOfTheRun) {
  const ProcessResult result = folder_.run({"export", "run", "--to", "csv", "--out", "tables"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "tables written\n");
  EXPECT_EQ(folder_.read("tables/history.csv"), folder_.read("run/history.csv"));
  EXPECT_TRUE(folder_.has("tables/nodes.csv"));
  EXPECT_TRUE(folder_.has("tables/segments.csv"));
}

TEST_F(Export, VtkGoesIntoTheRunByDefault) {
  const ProcessResult result = folder_.run({"export", "run", "--to", "vtk"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(folder_.read("run/vtk/frames.pvd"), folder_.read("run/frames.pvd"));
  EXPECT_EQ(folder_.run({"export", "run", "--to", "vtk"}).exit_code, 2);  // never overwritten
}

TEST_F(Export, RefusesWhatIsNoRun) {
  const ProcessResult result = folder_.run({"export", "nowhere", "--to", "csv"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("nowhere"));
  folder_.write("run/run.h5", "garbage");
  EXPECT_EQ(folder_.run({"export", "run", "--to", "csv", "--out", "tables"}).exit_code, 2);
  EXPECT_FALSE(folder_.has("tables"));
  EXPECT_FALSE(folder_.has("nowhere"));
}

}  // namespace
}  // namespace retiarius

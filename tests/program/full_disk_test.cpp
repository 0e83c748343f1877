// A place that takes no more in the middle of a run: a clear failure, what was written stays.
#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::ProcessResult;
using ::testing::StartsWith;
using testing::WorkFolder;

TEST(FullDisk, FileSizeLimitEndsTheRunInGoodOrder) {
  const WorkFolder folder;
  folder.write("m.toml", testing::endless_mission());
  testing::ProcessOptions options;
  options.file_size = 200'000;
  const ProcessResult result = folder.run({"run", "m.toml"}, options);
  EXPECT_EQ(result.signal, 0);
  EXPECT_EQ(result.exit_code, 1) << result.err;
  EXPECT_THAT(result.err,
              AllOf(StartsWith("retiarius: error: "), HasSubstr("out/m/"), HasSubstr("too large")));
  EXPECT_THAT(folder.read("out/m/summary.json"), HasSubstr("\"outcome\": \"failed\""));
  EXPECT_GT(testing::line_count(folder.read("out/m/history.csv")), 10u);
}

TEST(FullDisk, PlaceWithoutRoomIsRefusedAtOnce) {
  const WorkFolder folder;
  folder.write("m.toml", testing::small_mission());
  testing::ProcessOptions options;
  options.file_size = 0;
  options.out = "/dev/null";
  const ProcessResult result = folder.run({"run", "m.toml", "--out", "deep/out"}, options);
  EXPECT_EQ(result.signal, 0);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(folder.listing(), "m.toml");
}

}  // namespace
}  // namespace retiarius

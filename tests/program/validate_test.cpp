#include <gmock/gmock.h>

#include "retiarius/mission/reader.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::replaced;
using testing::small_mission;
using testing::WorkFolder;

TEST(Validate, PrintsAMissionThatReadsBackAndWritesNothing) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  const ProcessResult result =
      folder.run({"validate", "m.toml", "--set", "net.thread.radius=0.004"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const Mission mission = parse_mission(result.out);
  EXPECT_EQ(mission.title, "A small net");
  EXPECT_EQ(mission.net.thread.radius, 0.004);
  EXPECT_THAT(result.out, HasSubstr("friction"));  // a default
  EXPECT_EQ(folder.listing(), "m.toml");
}

TEST(Validate, ChecksWhatOnlyTheBuiltModelKnows) {
  const WorkFolder folder;
  folder.write("m.toml", replaced(small_mission(), "node = \"center\"", "node = \"corner9\""));
  const ProcessResult result = folder.run({"validate", "m.toml"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("corner9"));
  EXPECT_EQ(result.out, "");
}

TEST(Validate, TellsWhatLooksLikeAMistakeAsWarning) {
  const WorkFolder folder;
  folder.write("m.toml", replaced(small_mission(), "density = 1000.0", "density = 1.0"));
  const ProcessResult result = folder.run({"validate", "m.toml"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("retiarius: warning: net.thread.density = 1"));
}

TEST(Validate, ChecksTheSavedStateThatTheNetStartsFrom) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  folder.write("nothing", "not a checkpoint");
  const ProcessResult result = folder.run({"validate", "m.toml", "--set", "net.state=\"nothing\""});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("nothing"));
}

TEST(Validate, FullDiskBehindStandardOutputIsAnError) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  testing::ProcessOptions options;
  options.out = "/dev/full";
  const ProcessResult result = folder.run({"validate", "m.toml"}, options);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("cannot write to standard output: No space left on device"));
}

}  // namespace
}  // namespace retiarius

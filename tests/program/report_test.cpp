#include <gmock/gmock.h>

#include "retiarius/report/replay_page.hpp"
#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::small_mission;
using testing::WorkFolder;

TEST(Report, IsMadeAgainFromTheFolder) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "run"}).exit_code, 0);
  EXPECT_EQ(folder.read("run/mission.toml"), small_mission());
  const std::string page = folder.read("run/report.html");
  folder.write("run/report.html", "gone");
  const ProcessResult result = folder.run({"report", "run"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "run/report.html written\n");
  EXPECT_EQ(folder.read("run/report.html"), page);
  EXPECT_EQ(folder.run({"report", "run", "--out", "page.html"}).exit_code, 0);
  EXPECT_EQ(folder.read("page.html"), page);
}

TEST(Report, ComparesRuns) {
  if (!viewer_built_in()) GTEST_SKIP() << "built without the viewer";
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "one"}).exit_code, 0);
  ASSERT_EQ(
      folder.run({"run", "m.toml", "--out", "two", "--set", "net.thread.radius=0.008"}).exit_code,
      0);
  const ProcessResult result = folder.run({"report", "one", "two"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "comparison.html written\n");
  EXPECT_THAT(folder.read("comparison.html"), HasSubstr("data-run=\"two\""));
}

TEST(Report, RefusesWhatIsNoRun) {
  const WorkFolder folder;
  const ProcessResult result = folder.run({"report", "nowhere"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("there is no folder nowhere"));
  EXPECT_EQ(folder.listing(), "");
}

}  // namespace
}  // namespace retiarius

#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::WorkFolder;

TEST(New, WritesACommentedMissionThatIsValid) {
  const WorkFolder folder;
  const ProcessResult result = folder.run({"new", "first"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "first.toml written; run it with: retiarius run first.toml\n");
  EXPECT_THAT(folder.read("first.toml"), HasSubstr("title = \"first\""));
  EXPECT_THAT(folder.read("first.toml"), HasSubstr("# m, knot to knot"));
  EXPECT_EQ(folder.run({"validate", "first.toml"}).exit_code, 0);
  EXPECT_EQ(folder.listing(), "first.toml");
}

TEST(New, TakesAnEndingThatIsThereAlready) {
  const WorkFolder folder;
  EXPECT_EQ(folder.run({"new", "v1.5"}).exit_code, 0);
  EXPECT_EQ(folder.run({"new", "second.toml"}).exit_code, 0);
  EXPECT_EQ(folder.listing(), "second.toml v1.5.toml");
}

TEST(New, NeverOverwrites) {
  const WorkFolder folder;
  folder.write("first.toml", "mine");
  const ProcessResult result = folder.run({"new", "first"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "retiarius: error: first.toml exists and is not overwritten; give another name\n");
  EXPECT_EQ(folder.read("first.toml"), "mine");
}

TEST(New, RefusesNamesThatAreNoFile) {
  const WorkFolder folder;
  EXPECT_THAT(folder.run({"new", "a/"}).err, HasSubstr("\"a/\" names no file"));
  EXPECT_THAT(folder.run({"new", ""}).err, HasSubstr("names no file"));
  const ProcessResult result = folder.run({"new", "missing/first"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("cannot write missing/first.toml: No such file or directory"));
  EXPECT_EQ(folder.listing(), "");
}

}  // namespace
}  // namespace retiarius

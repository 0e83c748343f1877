#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;
using testing::replaced;
using testing::small_mission;
using testing::WorkFolder;

// The net moves up through a thin fixed panel, without contact.
std::string through_a_panel() {
  return replaced(small_mission(), "[[phase]]",
                  "[target]\nshape = \"box\"\nsize = [0.4, 0.4, 0.02]\nmotion = \"fixed\"\n"
                  "position = [0.0, 0.0, -0.2]\n\n[[phase]]");
}

TEST(CheckContactCommand, PassesARunWithoutBodiesAndCountsEveryStep) {
  const WorkFolder folder;
  folder.write("m.toml", small_mission());
  ASSERT_EQ(
      folder.run({"run", "m.toml", "--out", "run", "--set", "output.every_step=true"}).exit_code,
      0);
  const ProcessResult result = folder.run({"check-contact", "run"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("motions between them    20"));
}

TEST(CheckContactCommand, FindsWhatWentThroughAPanel) {
  const WorkFolder folder;
  folder.write("m.toml", through_a_panel());
  ASSERT_EQ(folder.run({"run", "m.toml", "--out", "run"}).exit_code, 0);
  const ProcessResult result = folder.run({"check-contact", "run"});
  EXPECT_EQ(result.exit_code, 1) << result.out;
  EXPECT_THAT(result.out, HasSubstr("crossing"));
  EXPECT_THAT(result.out, HasSubstr("target"));
  const ProcessResult json = folder.run({"check-contact", "run", "--json"});
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_THAT(json.out, HasSubstr("\"clean\": false"));
}

TEST(CheckContactCommand, RefusesWhatIsNoRun) {
  const WorkFolder folder;
  const ProcessResult result = folder.run({"check-contact", "nowhere"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("nowhere"));
}

}  // namespace
}  // namespace retiarius

// The missions in missions/ as a whole.
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

// A new mission needs a test of what it must show; then its name belongs here.
TEST(ReadyMissions, AreThoseThatTestsRun) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(RETIARIUS_SOURCE_DIR "/missions"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  EXPECT_THAT(names, UnorderedElementsAre("capture", "close", "drop-on-sphere", "fold",
                                          "hexagon-gravity", "shoot", "stiff-capture"));
}

TEST(ReadyMissions, FitThemselvesAndWarnOfNothing) {
  for (const auto& entry : fs::directory_iterator(RETIARIUS_SOURCE_DIR "/missions")) {
    if (entry.path().extension() != ".toml") continue;
    const Mission mission = read_mission(entry.path().string());
    EXPECT_FALSE(mission.title.empty()) << entry.path();
    EXPECT_THAT(mission_warnings(mission), IsEmpty()) << entry.path();
    EXPECT_NO_THROW(check_run(mission, MissionModel(mission))) << entry.path();
  }
}

}  // namespace
}  // namespace retiarius

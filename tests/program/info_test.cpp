#include <gmock/gmock.h>

#include "tests/program/subprocess.hpp"

namespace retiarius {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ProcessResult;
using testing::replaced;
using testing::small_mission;
using testing::WorkFolder;

std::string info_of(const std::string& mission, const std::vector<std::string>& more = {}) {
  const WorkFolder folder;
  std::vector<std::string> arguments{"info", folder.write("m.toml", mission)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const ProcessResult result = folder.run(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(folder.listing(), "m.toml");
  return result.out;
}

// The hexagon of side 1 m and mesh 0.2 m with four segments a piece.
TEST(Info, TellsSizesOfTheNet) {
  const std::string info =
      info_of(small_mission(), {"--set", "net.mesh=0.2", "--set", "net.segments=4"});
  EXPECT_THAT(info, ContainsRegex("\n  nodes +631\n"));
  EXPECT_THAT(info, ContainsRegex("\n  segments +720\n"));
  EXPECT_THAT(info, ContainsRegex("\n  joints +663\n"));
  EXPECT_THAT(info, ContainsRegex("\n  corners +6\n"));
  EXPECT_THAT(info, ContainsRegex("\n  median rest length +0.05 m\n"));
}

// A square of two by two cells: 24 segments of 0.25 m of pi 0.01^2 1000 kg/m; EA = 1e6 pi 1e-4 N,
// EI = 1e6 pi 1e-8 / 4 N m2; c = sqrt(E / rho).
TEST(Info, TellsMassesAndStiffness) {
  const std::string info =
      info_of(small_mission(), {"--set", "net.pattern=square", "--set", "net.corner_mass.mass=0.5",
                                "--set", "net.thread.bending=bounded"});
  EXPECT_THAT(info, ContainsRegex("\n  segments +24\n"));
  EXPECT_THAT(info, ContainsRegex("\n  mass of the net +1.885 kg\n"));
  EXPECT_THAT(info, ContainsRegex("\n  mass at corners +2 kg\n"));
  EXPECT_THAT(info, ContainsRegex("\n  total mass +3.885 kg\n"));
  EXPECT_THAT(info, ContainsRegex("\n  thread +314.2 N +0.007854 N m2 +0.01 m +0.3142 kg/m +"
                                  "31.62 m/s\n"));
}

TEST(Info, TellsTheStableStepAndTheSegmentThatSetsIt) {
  EXPECT_THAT(info_of(small_mission()),
              ContainsRegex("stable explicit step +0\\.00[0-9]+ s, set by segment [0-9]+ "
                            "\\(nodes [0-9]+ and [0-9]+, 0.25 m long\\)"));
}

TEST(Info, TellsTheSubstepsOfAnExplicitMission) {
  const std::string mission =
      replaced(small_mission(), "[integrator]\n", "[integrator]\nmethod = \"explicit\"\n");
  EXPECT_THAT(info_of(mission), ContainsRegex("explicit sub-steps in it +[1-9][0-9]*\n"));
}

TEST(Info, TellsBodiesAndNeeds) {
  const std::string target =
      "\n[target]\nshape = \"box\"\nsize = [1.0, 2.0, 3.0]\nmass = 12.0\n"
      "position = [0.0, 0.0, 5.0]\n";
  const std::string info = info_of(small_mission() + target);
  // m (b^2 + c^2) / 12
  EXPECT_THAT(info, ContainsRegex("\n  target +12 kg +5, 10, 13 kg m2\n"));
  EXPECT_THAT(info, ContainsRegex("\n  frames +at most 3\n"));
  EXPECT_THAT(info, ContainsRegex("\n  memory +about [0-9.]+ [kM]B\n"));
  EXPECT_THAT(info_of(small_mission()), Not(HasSubstr("bodies")));
}

TEST(Info, SaysWhereTheEndIsUnknown) {
  EXPECT_THAT(info_of(replaced(small_mission(), "time >= 0.2", "widest")),
              HasSubstr("unknown: no time by which the last phase ends"));
}

}  // namespace
}  // namespace retiarius

#include <gmock/gmock.h>

#include "retiarius/mission/set_override.hpp"
#include "texts.hpp"

namespace retiarius {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Mission set(const std::vector<std::string>& overrides, const std::string& base = kLeast) {
  return parse_mission(base, "m.toml", ".", overrides);
}

const std::string kSphere = "[target]\nshape = \"sphere\"\nradius = 1.0\nmass = 1.0\n";
const std::string kTwoSpheres =
    "[[target]]\nshape = \"sphere\"\nradius = 1.0\nmass = 1.0\n"
    "[[target]]\nshape = \"sphere\"\nradius = 2.0\nmass = 1.0\n";

TEST(Override, BracketsStandForOneNumberOfAList) {
  const Mission m =
      set({"target.position=[1, 2, 3]", "target.position[1]=-0.5", "target.spin_deg[2]=7"},
          kLeast + kSphere);
  EXPECT_EQ(m.targets[0].position, Vec3(1.0, -0.5, 3.0));
  EXPECT_EQ(m.targets[0].spin_deg, Vec3(0.0, 0.0, 7.0));
}

TEST(Override, ReplacesValues) {
  EXPECT_EQ(set({"net.thread.radius=0.004"}).net.thread.radius, 0.004);
  EXPECT_EQ(set({" net.thread.radius = 0.004 "}).net.thread.radius, 0.004);
  EXPECT_EQ(set({"net.thread.radius=1e-3", "net.thread.radius=0.002"}).net.thread.radius, 0.002);
  EXPECT_EQ(set({"phase[0].until=time >= 3"}).phases[0].until, "time >= 3");
}

TEST(Override, MakesMissingTables) {
  const Mission m = set({"environment.gravity=[0,0,-9.81]", "phase[0].integrator.step=0.005",
                         "net.corner_mass.mass=2", "probe[0].node=corner1", "probe[1].node=3"});
  EXPECT_EQ(m.environment.gravity.z(), -9.81);
  EXPECT_EQ(m.phases[0].integrator.step, 0.005);
  EXPECT_EQ(m.integrator.step, 0.01);
  EXPECT_EQ(m.net.corner_mass.mass, 2.0);
  ASSERT_EQ(m.probes.size(), 2u);
  EXPECT_EQ(m.probes[0].node, "corner1");
  EXPECT_EQ(m.probes[1].node, "3");
}

TEST(Override, AppendsAPhase) {
  const Mission m = set({"phase[1].kind=spread", "phase[1].until=widest"});
  ASSERT_EQ(m.phases.size(), 2u);
  EXPECT_EQ(m.phases[1].kind, PhaseKind::spread);
}

TEST(Override, TargetIsTargetZero) {
  for (const std::string path : {"target.radius=3", "target[0].radius=3"}) {
    EXPECT_EQ(set({path}, kLeast + kSphere).targets[0].radius, 3.0);
    const Mission two = set({path}, kLeast + kTwoSpheres);
    EXPECT_EQ(two.targets[0].radius, 3.0);
    EXPECT_EQ(two.targets[1].radius, 2.0);
  }
  EXPECT_EQ(set({"target[1].radius=3"}, kLeast + kTwoSpheres).targets[1].radius, 3.0);
  EXPECT_EQ(set({"target[0].shape=sphere", "target.radius=3", "target.mass=1"}).targets.size(), 1u);
}

TEST(Override, TextsNeedNoQuotes) {
  EXPECT_EQ(set({"contact.method=modified-mass"}).contact.method, ContactMethod::modified_mass);
  EXPECT_EQ(set({"contact.method=\"none\""}).contact.method, ContactMethod::none);
  EXPECT_EQ(set({"title=5"}).title, "5");
  EXPECT_EQ(set({"title=true"}).title, "true");
  EXPECT_EQ(set({"title=a = b"}).title, "a = b");
  EXPECT_THAT(set({"phase[0].fix=corners"}).phases[0].fix, ElementsAre("corners"));
  EXPECT_THAT(set({"phase[0].fix=['corner0', 'center']"}).phases[0].fix,
              ElementsAre("corner0", "center"));
}

struct BadOverride {
  std::string text, error;
};

TEST(Override, ErrorsNameTheOverride) {
  const std::vector<BadOverride> cases = {
      {"net.thread.radis=1", "unknown key net.thread.radis, did you mean radius?"},
      {"net.thread.radius=-1", "net.thread.radius = -1: must be greater than 0 m"},
      {"net.thread.radius=big", "\"big\" is not a TOML value"},
      {"net.thread.radius=\"1\"", "net.thread.radius = \"1\": must be a number in m"},
      {"net.thread.radius=", "the value is missing"},
      {"net.thread.radius", "expected path=value"},
      {"=1", "the path has an empty name"},
      {"net..radius=1", "the path has an empty name"},
      {"net.tread.radius=1", "unknown table net.tread, did you mean thread?"},
      {"phasse[0].kind=free", "unknown table phasse, did you mean phase?"},
      {"net.side.radius=1", "net.side is not a table"},
      {"titel=x", "unknown key titel, did you mean title?"},
      {"phase.kind=free", "phase is a list of tables, write phase[0]"},
      {"phase[5].kind=free", "phase[5] does not exist: there are 1"},
      {"environment.gravity[3]=1", "environment.gravity[3] does not exist: there are 3"},
      {"environment.gravity[0]=x", "\"x\" is not a TOML value"},
      {"environment.gravity[0]=true", "the value must be a number"},
      {"environment.damping[0]=1", "environment.damping is no list of numbers"},
      {"net.thread[0]=1", "net.thread is a table, not a list of numbers"},
      {"environment.gravty[0]=1", "unknown key environment.gravty, did you mean gravity?"},
      {"phase[x].kind=free", "\"phase[x]\" is not a name with an index, as in phase[0]"},
      {"phase[-1].kind=free", "\"phase[-1]\" is not a name with an index, as in phase[0]"},
      {"phase[0.kind=free", "\"phase[0\" is not a name with an index, as in phase[0]"},
      {"net[0].side=1", "net is one table, write it without brackets"},
      {"target[1].radius=1", "there is no list of targets, [[target]], to index"},
      {"phase[0].kind=fly", "phase[0].kind = \"fly\": must be one of \"free\""},
      {"phase[0].until=tme > 1", "at character 1: unknown name tme"},
      {"net.thread.bendin=none", "unknown key net.thread.bendin, did you mean bending?"},
      {"title=\xff", "the value is not a text: "},
      {"net=3", "net must be a table: write [net]"},
      {"net.side=1\nx=2", "the value must be one TOML value"},
      {"net.sides=5", "net.sides belongs to pattern polygon, not hexagon"}};
  for (const BadOverride& bad : cases) {
    const std::string error = error_of(kLeast, {bad.text});
    EXPECT_THAT(error, testing::StartsWith("--set " + bad.text + ": "));
    EXPECT_THAT(error, HasSubstr(bad.error));
  }
}

}  // namespace
}  // namespace retiarius

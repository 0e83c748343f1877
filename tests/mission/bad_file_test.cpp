// Files that are no missions, and missions whose values do not fit each other.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "retiarius/mission/reader.hpp"
#include "texts.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

class BadFile : public testing::Test {
 protected:
  BadFile() {
    std::string pattern = (fs::temp_directory_path() / "retiarius-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    path_ = (folder_ / "m.toml").string();
  }
  ~BadFile() override { fs::remove_all(folder_); }

  std::string error_reading(const std::string& content) {
    std::ofstream(path_, std::ios::binary) << content;
    return error_at(path_);
  }
  static std::string error_at(const std::string& path) {
    try {
      read_mission(path);
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  }

  fs::path folder_;
  std::string path_;
};

TEST_F(BadFile, MissingFolderAndEmpty) {
  const std::string missing = (folder_ / "none.toml").string();
  EXPECT_EQ(error_at(missing), missing + ": there is no such mission file");
  EXPECT_EQ(error_at(folder_.string()),
            folder_.string() + ": is a folder; a mission file is expected");
  EXPECT_EQ(error_at(""), "the name of the mission file is empty");
  EXPECT_THAT(error_reading(""), StartsWith(path_ + ": is empty; a mission needs at least"));
  EXPECT_THAT(error_reading(" \r\n\t\n"), HasSubstr("is empty"));
}

TEST_F(BadFile, BinaryAndInvalidText) {
  EXPECT_EQ(error_reading(std::string("\x7f"
                                      "ELF\0\1",
                                      6)),
            path_ + ": is not a text file (byte 4 is zero)");
  EXPECT_THAT(error_reading("title = \"\xff\xfe\"\n"), StartsWith(path_ + ":1:"));
  EXPECT_THAT(error_reading("title = \"\xff\xfe\"\n"), HasSubstr("syntax error: "));
  EXPECT_THAT(error_reading("\x89PNG\r\n\x1a\n"), HasSubstr("syntax error: "));
}

TEST_F(BadFile, TooLarge) {
  EXPECT_EQ(error_reading(std::string((16u << 20) + 1, '\n')),
            path_ + ": is larger than 16 MiB; a mission file is expected");
}

TEST_F(BadFile, DevicesWithoutEnd) {
  EXPECT_EQ(error_at("/dev/zero"), "/dev/zero: is larger than 16 MiB; a mission file is expected");
  EXPECT_THAT(error_at("/dev/null"), HasSubstr("is empty"));
}

TEST_F(BadFile, SyntaxErrorsHaveLineAndColumn) {
  EXPECT_THAT(error_reading("[net]\nside = = 1\n"), StartsWith(path_ + ":2:8: syntax error: "));
  EXPECT_THAT(error_reading("[net\nside = 1\n"), StartsWith(path_ + ":1:5: syntax error: "));
  EXPECT_THAT(error_reading("[net]\nside = 1\nside = 2\n"), StartsWith(path_ + ":3:"));
  EXPECT_THAT(error_reading("a = " + std::string(100000, '[')), HasSubstr("syntax error: "));
}

TEST_F(BadFile, GoodFileRemembersWhereItIs) {
  EXPECT_EQ(error_reading(kLeast), "");
  const Mission mission = read_mission(path_, {"net.side=2"});
  EXPECT_EQ(mission.file, path_);
  EXPECT_EQ(mission.folder, folder_.string());
  EXPECT_EQ(mission.net.side, 2.0);
}

struct BadMission {
  std::string text, error;
};

void expect_errors(const std::vector<BadMission>& cases) {
  for (const BadMission& bad : cases) EXPECT_EQ(error_of(bad.text), bad.error);
}

TEST(BadMission, UnknownKeysAndWords) {
  expect_errors(
      {{with("radius = 0.01", "radis = 0.01"),
        "m.toml:9:1: unknown key net.thread.radis, did you mean radius?"},
       {"titel = \"x\"\n" + kLeast, "m.toml:1:1: unknown key titel, did you mean title?"},
       {with("[[phase]]", "[phases]"), "m.toml:11:2: unknown key phases, did you mean phase?"},
       {kLeast + "  qqqqqqqq = 1\n",
        "m.toml:14:3: unknown key phase[0].qqqqqqqq; allowed: move, environment, integrator, "
        "contact, kind, name, fix, until, speed, half_angle_deg, delay, axis, grips, grip_spacing, "
        "ratio, duration, path, distance, radius"},
       {with("hexagon", "hexagn"),
        "m.toml:2:11: net.pattern = \"hexagn\": must be one of \"hexagon\", \"square\", "
        "\"triangle\", \"polygon\", \"file\", did you mean hexagon?"},
       {kLeast + "[integrator]\nmethod = \"implicit_euler\"\n",
        "m.toml:15:10: integrator.method = \"implicit_euler\": must be one of \"implicit-euler\", "
        "\"newmark\", \"midpoint\", \"generalised-alpha\", \"tr-bdf2\", \"explicit\", \"static\", "
        "\"auto\", did you mean "
        "implicit-euler?"}});
}

TEST(BadMission, WhatIsNotAvailable) {
  expect_errors(
      {{with("\"free\"", "\"tug\""),
        "m.toml:12:8: phase[0].kind = \"tug\": is not available yet; available: "
        "\"free\", \"fold\", \"shoot\", \"spread\", \"contact\", \"close\""},
       {kLeast + "[contact]\nself = true\n",
        "m.toml:15:8: contact.self = true: threads touch each other only with contact.method = "
        "\"barrier\""},
       {kLeast + "[contact]\nmethod = \"barrier\"\n[integrator]\nmethod = \"explicit\"\n",
        "m.toml:15:10: contact.method = \"barrier\": the explicit integrator has contact by "
        "modified mass only"},
       {"format = 2\n" + kLeast, "m.toml:1:10: format = 2: this program reads format 1"}});
  EXPECT_EQ(error_of("format = 1\n" + kLeast + "[contact]\nself = false\n"), "");
}

TEST(BadMission, WhatIsMissing) {
  expect_errors(
      {{"title = \"x\"\n", "m.toml: net is missing: add a table [net]"},
       {with("side = 1.0\n", ""),
        "m.toml:1:1: net.side is missing: give a number in m (length of one side of the outline)"},
       {"[net]\npattern = \"square\"\nside = 1\nmesh = 1\n",
        "m.toml:1:1: net.thread is missing: add a table [net.thread]"},
       {with("kind = \"free\"\n", ""),
        "m.toml:11:1: phase[0].kind is missing: give one of free, fold, shoot, spread, contact, "
        "close (what the phase does)"},
       {kLeast.substr(0, kLeast.find("[[phase]]")),
        "m.toml: phase is missing: a mission needs at least one [[phase]]"},
       {with("\"free\"", "\"shoot\""),
        "m.toml:11:1: phase[0].speed is missing: give a number or a list of numbers in m/s (of the "
        "corner masses; a list gives one per corner)"}});
}

TEST(BadMission, WhatMustBeATable) {
  expect_errors(
      {{"net = 3\n", "m.toml:1:7: net must be a table: write [net]"},
       {with("[[phase]]", "[phase]"),
        "m.toml:11:1: phase must be a list of tables: write [[phase]]"},
       {"probe = [1]\n" + kLeast, "m.toml:1:9: probe must be a list of tables: write [[probe]]"},
       {"target = 3\n" + kLeast,
        "m.toml:1:10: target must be a list of tables: write [[target]]"}});
}

TEST(BadMission, Triggers) {
  expect_errors({{with("time >= 2.0", "time >> 2.0"),
                  "m.toml:13:16: phase[0].until = \"time >> 2.0\": at character 7: expected a "
                  "number, found \">\""},
                 {with("\"time >= 2.0\"", "'''tme > 2'''"),
                  "m.toml:13:12: phase[0].until = \"tme > 2\": at character 1: unknown name tme, "
                  "did you mean time?"},
                 {with("\"time >= 2.0\"", "\"time \\u003E\\u003E 2\""),
                  "m.toml:13: phase[0].until = \"time >> 2\": at character 7: expected a number, "
                  "found \">\""}});
}

TEST(BadMission, ExplicitStepsAreNotAdaptive) {
  expect_errors(
      {{kLeast + "[integrator]\nmethod = \"explicit\"\nadaptive = true\n",
        "m.toml:16:12: integrator.adaptive = true: explicit steps are not adaptive; leave "
        "it out or take another integrator.method"}});
}

TEST(BadMission, OutputMustFallOnSteps) {
  const std::string output = "[output]\ninterval = 0.01\n";
  expect_errors(
      {{kLeast + "[integrator]\nstep = 0.003\n",
        "m.toml:15:8: integrator.step = 0.003 s does not divide output.interval = 0.01 s; change "
        "one so that rows fall on steps"},
       {kLeast + "[output]\ninterval = 0.005\nframe_interval = 0.05\n",
        "m.toml:15:12: integrator.step = 0.01 s does not divide output.interval = 0.005 s; change "
        "one so that rows fall on steps"},
       {kLeast + "[phase.integrator]\nstep = 0.02\n" + output,
        "m.toml:15:8: phase[0].integrator.step = 0.02 s does not divide output.interval = 0.01 s; "
        "change one so that rows fall on steps"},
       {kLeast + output + "frame_interval = 0.025\n",
        "m.toml:16:18: output.frame_interval = 0.025 s is not a multiple of output.interval = "
        "0.01 s"}});
  EXPECT_EQ(error_of(kLeast + "[integrator]\nmethod = \"static\"\nstep = 0.003\n"), "");
  EXPECT_EQ(error_of(kLeast + "[integrator]\nstep = 1e-3\n" + output + "frame_interval = 0.3\n"),
            "");
}

TEST(BadMission, SingleUpdatesNeedWhatTheyRelyOn) {
  const std::string single = "newton = \"single\"\n";
  EXPECT_EQ(error_of(kLeast + "[integrator]\n" + single), "");
  expect_errors(
      {{kLeast + "[integrator]\nmethod = \"newmark\"\n" + single,
        "m.toml:16:10: integrator.newton = \"single\" needs method = \"implicit-euler\", whose "
        "damping it relies on"},
       {with("radius = 0.01", "radius = 0.01\ncompression = false") + "[phase.integrator]\n" +
            single,
        "m.toml:16:10: phase[0].integrator.newton = \"single\" needs net.thread.compression = "
        "true: "
        "a single update takes tension-only threads far beyond where they become taut"}});
}

TEST(BadMission, Targets) {
  const std::string sphere = kLeast + "[target]\nshape = \"sphere\"\nradius = 1.0\n";
  expect_errors(
      {{sphere,
        "m.toml:14:1: target is free and needs mass or density, or write motion = \"fixed\""},
       {sphere + "mass = 1\ndensity = 1\n",
        "m.toml:18:11: target.density and mass are both given; give one of them"},
       {sphere + "mass = 1\ninertia = [1, 1, 3]\n",
        "m.toml:18:11: target.inertia = [1, 1, 3]: no solid has these moments; each is at most the "
        "sum of the other two"},
       {sphere + "motion = \"fixed\"\nvelocity = [1, 0, 0]\n",
        "m.toml:18:12: target.velocity must be zero: it is fixed"},
       {sphere + "motion = \"fixed\"\nspin_deg = [1, 0, 0]\n",
        "m.toml:18:12: target.spin_deg must be zero: it is fixed"},
       {kLeast + "[[target]]\nshape = \"plane\"\n",
        "m.toml:14:1: target[0].motion = \"free\": a plane must be fixed, write motion = "
        "\"fixed\""},
       {sphere + "mass = 1\nlength = 2\n",
        "m.toml:18:1: target.length belongs to shape cylinder, capsule, cone, not sphere"},
       {kLeast + "[target]\nshape = \"mesh\"\nfile = \"no.stl\"\nmass = 1\n",
        "m.toml:16:8: target.file = \"no.stl\": there is no ./no.stl"}});
  const std::string fixed = "[[target]]\nname = \"a\"\nshape = \"plane\"\nmotion = \"fixed\"\n";
  EXPECT_EQ(error_of(kLeast + fixed + fixed),
            "m.toml:19:8: target[1].name = \"a\" is taken by another target");
  EXPECT_EQ(error_of(sphere + "motion = \"fixed\"\n"), "");
}

TEST(BadMission, Net) {
  expect_errors(
      {{with("mesh = 0.2", "mesh = 2"), "m.toml:4:8: net.mesh = 2 m is larger than net.side = 1 m"},
       {with("mesh = 0.2", "mesh = 0.2\nzigzag = true\nscale = 1.5"),
        "m.toml:5:10: net.zigzag needs net.scale of at most 1, not 1.5"},
       {with("mesh = 0.2", "mesh = 0.2\nstate = \".\"\nscale = 0.5"),
        "m.toml:5:9: net.state gives the initial positions; leave out net.scale and net.zigzag"},
       {with("mesh = 0.2", "mesh = 0.2\nstate = \"nowhere\""),
        "m.toml:5:9: net.state = \"nowhere\": there is no ./nowhere"},
       {with("mesh = 0.2", "mesh = 0.2\ncell = \"square\"", with("hexagon", "triangle")),
        "m.toml:5:8: net.cell = \"square\" belongs to pattern square; triangle has natural, "
        "diamond"}});
}

TEST(BadMission, Phases) {
  const std::string shoot = with("\"free\"", "\"shoot\"");
  const std::string fold = with("\"free\"", "\"fold\"") + "duration = 1\n";
  const std::string move = kLeast + "[[phase.move]]\nnodes = \"center\"\n";
  expect_errors(
      {{kLeast + "fix = [\"none\", \"center\"]\n",
        "m.toml:14:7: phase[0].fix mixes none with names of nodes"},
       {shoot + "speed = [1, 2]\n",
        "m.toml:14:9: phase[0].speed lists 2 values, but the net has 6 corners: give one value or "
        "6"},
       {shoot + "speed = 1\ndelay = [1, 2, 3, 4, 5]\n",
        "m.toml:15:9: phase[0].delay lists 5 values, but the net has 6 corners: give one value or "
        "6"},
       {shoot + "speed = 1\naxis = [0, 0, 0]\n",
        "m.toml:15:8: phase[0].axis = [0, 0, 0] is no direction"},
       {fold,
        "m.toml:11:1: phase[0].grip_spacing is missing: grips = \"lattice\" needs it, in m, "
        "above 0"},
       {fold + "grips = [\"spokes\", \"center\"]\n",
        "m.toml:15:9: phase[0].grips mixes spokes with other grips"},
       {with("\"free\"", "\"close\""),
        "m.toml:12:8: phase[0].kind = \"close\" needs a [target] to close around"},
       {move, "m.toml:14:1: phase[0].move[0] gives neither displacement nor velocity"},
       {move + "displacement = [1, 0, 0]\n",
        "m.toml:14:1: phase[0].move[0].duration is missing: a displacement needs the time it "
        "takes, in s"},
       {move + "displacement = [1, 0, 0]\nvelocity = [1, 0, 0]\nduration = 1\n",
        "m.toml:17:12: phase[0].move[0].velocity and displacement are both given"}});
  const std::string named = "[[phase]]\nname = \"a\"\nkind = \"free\"\nuntil = \"widest\"\n";
  EXPECT_EQ(error_of(kLeast + named + named),
            "m.toml:19:8: phase[2].name = \"a\" is taken by another phase");
  EXPECT_EQ(error_of(fold + "grips = [\"corner0\", \"center\"]\n"), "");
}

TEST(BadMission, Probes) {
  const std::string probe = "[[probe]]\nname = \"a\"\nnode = \"center\"\n";
  EXPECT_EQ(error_of(kLeast + probe + probe),
            "m.toml:18:8: probe[1].name = \"a\" is taken by another probe");
  EXPECT_EQ(error_of(kLeast + with("\"a\"", "\"a,b\"", probe)),
            "m.toml:15:8: probe[0].name = \"a,b\": use letters, digits, _ and -");
}

TEST(Warnings, NameSuspiciousUnits) {
  const auto warnings = [](const std::vector<std::string>& set) {
    return mission_warnings(parse_mission(kLeast, "m.toml", ".", set));
  };
  EXPECT_THAT(warnings({}), testing::IsEmpty());
  EXPECT_THAT(warnings({"net.thread.radius=0.5"}),
              testing::Contains(HasSubstr("thicker than 20 cm; millimetres?")));
  EXPECT_THAT(warnings({"net.thread.young_modulus=70"}),
              testing::ElementsAre(HasSubstr("softer than any thread; GPa?")));
  EXPECT_THAT(warnings({"net.thread.density=1.4"}),
              testing::ElementsAre(HasSubstr("lighter than any fibre; g/cm3?")));
  EXPECT_THAT(warnings({"net.segments=10"}),
              testing::ElementsAre(HasSubstr("is large for segments of 0.02 m")));
  EXPECT_THAT(warnings({"net.thread.bending_stiffness=1"}),
              testing::ElementsAre(HasSubstr("has no effect")));
  EXPECT_THAT(warnings({"phase[0].until=contact or time >= 1"}),
              testing::ElementsAre(HasSubstr("waits for contact, but there is no [target]")));
  EXPECT_THAT(warnings({"phase[0].kind=shoot", "phase[0].speed=1"}),
              testing::ElementsAre(HasSubstr("net.corner_mass.mass is 0")));
  EXPECT_THAT(warnings({"target.shape=plane", "target.motion=fixed"}),
              testing::ElementsAre(HasSubstr("the net goes through it")));
}

}  // namespace
}  // namespace retiarius

// A run that is interrupted or dies and is resumed leaves what one leaves that was not.
#include "retiarius/record/resume.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/record/file.hpp"
#include "tests/record/resumed_run.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::Break;
using testing::by_implicit_methods;
using testing::error_text;
using testing::expect_resumes;
using testing::expect_same_results;
using ::testing::HasSubstr;
using testing::resume_in;
using testing::ResumeCase;
using testing::run_into;
using testing::run_with_breaks;
using testing::TemporaryFolder;

// A small net that is folded, shot with a delay of one corner, spreads, meets a tumbling target
// with friction, is closed after a delay, and settles: every kind of phase, with steps between.
std::string capture() {
  return R"(
[net]
pattern = "square"
side = 2.0
mesh = 0.5
segments = 2

[net.thread]
young_modulus = 1.0e7
density = 1200.0
radius = 0.003
bending = "bounded"
bending_stiffness = 1.0e-4
compression = false
material_damping = 1.0e-3
strength = 1.0

[net.corner_mass]
mass = 0.2

[target]
shape = "box"
size = [0.7, 0.6, 0.4]
mass = 20.0
position = [0.0, 0.0, 1.0]
velocity = [0.0, 0.0, -0.2]
spin_deg = [20.0, 40.0, 10.0]

[environment]
damping = 0.1

[integrator]
step = 0.005
max_iterations = 200

[contact]
method = "modified-mass"
friction = 0.3

[[phase]]
kind = "fold"
grips = "lattice"
grip_spacing = 1.0
ratio = 0.5
duration = 0.15
until = "phase_time >= 0.2"
[phase.environment]
gravity = [0.0, 0.0, -9.81]
damping = 4.0

[[phase]]
kind = "shoot"
speed = 5.0
half_angle_deg = 40.0
delay = [0.0, 0.01, 0.0, 0.02]
until = "phase_time >= 0.1"

[[phase]]
kind = "spread"
until = "contact or phase_time >= 0.15"

[[phase]]
kind = "close"
delay = 0.02
distance = 0.3
radius = 0.2
speed = 5.0
until = "phase_time >= 0.3"

[[phase]]
kind = "contact"
until = "phase_time >= 0.2"

[[probe]]
name = "corner"
node = "corner0"

[output]
interval = 0.01
frame_interval = 0.05
)";
}

// A net that first hangs at rest, then is moved, one side held.
std::string moved() {
  return R"(
[net]
pattern = "hexagon"
side = 1.0
mesh = 0.5
segments = 2

[net.thread]
young_modulus = 1.0e6
density = 1000.0
radius = 0.005
material_damping = 1.0e-3

[environment]
gravity = [0.0, 0.0, -9.81]

[[target]]
shape = "capsule"
radius = 0.2
length = 1.0
motion = "fixed"
position = [0.1, 0.0, -0.9]

[integrator]
step = 0.005
max_iterations = 200

[contact]
method = "modified-mass"
friction = 0.2

[[phase]]
kind = "free"
name = "hang"
fix = "corners"
until = "time >= 0.0"
[phase.integrator]
method = "static"
[phase.contact]
method = "none"

[[phase]]
kind = "free"
name = "move"
fix = ["corner0", "corner1"]
until = "phase_time >= 0.4"
[[phase.move]]
nodes = ["corner3", "corner4"]
displacement = [0.0, 0.2, 0.1]
duration = 0.2

[[phase]]
kind = "free"
name = "fall"
until = "phase_time >= 0.2"

[output]
interval = 0.01
frame_interval = 0.02
)";
}

class Resume : public ::testing::TestWithParam<ResumeCase> {};

TEST_P(Resume, ACaptureLeavesWhatTheWholeRunLeaves) {
  expect_resumes(capture(), GetParam(), Outcome::broke);
}

TEST_P(Resume, AMovedNetLeavesWhatTheWholeRunLeaves) {
  expect_resumes(moved(), GetParam(), Outcome::finished);
}

INSTANTIATE_TEST_SUITE_P(Cases, Resume,
                         ::testing::ValuesIn(by_implicit_methods(
                             {{"explicit_differences", {"integrator.method=explicit"}},
                              {"compression", {"net.thread.compression=true"}},
                              {"no_contact", {"contact.method=none"}},
                              {"no_friction", {"contact.friction=0.0"}}})),
                         testing::name_of);

Mission small() { return parse_mission(moved(), "m", ".", {"output.frame_interval=0.1"}); }

// A stop before the first step, and one at every step of a phase's beginning.
TEST(ResumeOften, AtEveryStepForAWhile) {
  const TemporaryFolder folder;
  run_into(folder / "whole", small());
  std::vector<Break> breaks(12, Break{Break::Kind::stopped, 1});
  EXPECT_EQ(run_with_breaks(folder / "broken", small(), breaks), 12);
  expect_same_results(folder / "whole", folder / "broken");
}

TEST(ResumeTorn, TakesTheCheckpointBefore) {
  const TemporaryFolder folder;
  run_into(folder / "whole", small());
  run_into(folder / "broken", small(), {{Break::Kind::stopped, 70}});
  const std::string bytes = read_whole_file(folder / "broken/checkpoint");
  write_atomically(folder / "broken/checkpoint", bytes.substr(0, bytes.size() / 2));
  const ResumableRun found = find_resumable(folder / "broken");
  EXPECT_EQ(found.used, folder / "broken/checkpoint.previous");
  EXPECT_THAT(found.passed_over, HasSubstr("its length is not the one it states"));
  EXPECT_EQ(resume_in(folder / "broken", small()).outcome, Outcome::finished);
  expect_same_results(folder / "whole", folder / "broken");
}

// The newest checkpoint may have reached the disk before the frames that it counts.
TEST(ResumeTorn, TakesTheCheckpointBeforeWhereFramesAreLost) {
  const TemporaryFolder folder;
  run_into(folder / "whole", small());
  run_into(folder / "broken", small(), {{Break::Kind::stopped, 30}});
  std::filesystem::copy(folder / "broken/run.h5", folder / "run.h5");
  std::filesystem::copy(folder / "broken/checkpoint", folder / "checkpoint");
  resume_in(folder / "broken", small(), {{Break::Kind::stopped, 50}});
  std::filesystem::rename(folder / "run.h5", folder / "broken/run.h5");
  EXPECT_THAT(error_text<InputError>([&] { find_resumable(folder / "broken"); }),
              HasSubstr("checkpoint counts "));
  std::filesystem::rename(folder / "checkpoint", folder / "broken/checkpoint.previous");
  EXPECT_EQ(find_resumable(folder / "broken").used, folder / "broken/checkpoint.previous");
  EXPECT_EQ(resume_in(folder / "broken", small()).outcome, Outcome::finished);
  expect_same_results(folder / "whole", folder / "broken");
}

// While a run is told again its files are written under other names.
TEST(ResumeTorn, DyingWhileResumingLosesNothing) {
  const TemporaryFolder folder;
  run_into(folder / "whole", small());
  run_into(folder / "broken", small(), {{Break::Kind::died, 70}});
  for (const char* name : {"history.csv.new", "run.h5.new", "replay.bin.new", "checkpoint.new"})
    write_atomically(folder / ("broken/" + std::string(name)), "torn");
  EXPECT_EQ(resume_in(folder / "broken", small()).outcome, Outcome::finished);
  expect_same_results(folder / "whole", folder / "broken");
}

TEST(FindResumable, SaysWhatIsWrong) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_text<InputError>([&] { find_resumable(folder / "none"); }),
              HasSubstr("it is not the folder of a run"));
  EXPECT_THAT(error_text<InputError>([&] { find_resumable(folder.path()); }),
              HasSubstr("it has no checkpoint"));
  write_atomically(folder / "checkpoint", encode_checkpoint({}));
  EXPECT_THAT(error_text<InputError>([&] { find_resumable(folder.path()); }),
              HasSubstr("checkpoint holds a state alone, not a run"));
}

TEST(FindResumable, KnowsARunThatHasEnded) {
  const TemporaryFolder folder;
  run_into(folder / "whole", small());
  const ResumableRun found = find_resumable(folder / "whole");
  EXPECT_TRUE(found.saved.checkpoint.ended);
  EXPECT_THAT(error_text<InputError>([&] { resume_in(folder / "whole", small()); }),
              HasSubstr("has come to its end"));
}

TEST(RunMission, RefusesACheckpointOfAnotherMission) {
  const TemporaryFolder folder;
  run_into(folder / "broken", small(), {{Break::Kind::stopped, 30}});
  EXPECT_THAT(error_text<InputError>([&] {
                resume_in(folder / "broken", parse_mission(moved(), "m", ".", {"net.mesh=0.25"}));
              }),
              HasSubstr("the saved state has 55 nodes"));
  EXPECT_THAT(
      error_text<InputError>([&] { resume_in(folder / "broken", parse_mission(capture())); }),
      HasSubstr("resume"));
}

TEST(CheckIdentity, NamesWhatDiffers) {
  const RunIdentity run{"1.0", "abc", "avx2", 1, 2};
  EXPECT_NO_THROW(check_identity(run, run));
  const auto complaint = [&](auto change) {
    RunIdentity other = run;
    change(other);
    return error_text<InputError>([&] { check_identity(run, other); });
  };
  EXPECT_THAT(complaint([](RunIdentity& r) { r.version = "1.1"; }),
              HasSubstr("begun by retiarius 1.0 (abc), this is 1.1 (abc)"));
  EXPECT_THAT(complaint([](RunIdentity& r) { r.revision = "abd"; }),
              HasSubstr("this is 1.0 (abd)"));
  EXPECT_THAT(complaint([](RunIdentity& r) { r.kernels = "portable"; }),
              HasSubstr("with the kernels avx2, these are portable"));
  EXPECT_THAT(complaint([](RunIdentity& r) { r.mission = 5; }), HasSubstr("resolved.toml"));
  EXPECT_THAT(complaint([](RunIdentity& r) { r.model = 5; }), HasSubstr("a file that it names"));
}

}  // namespace
}  // namespace retiarius

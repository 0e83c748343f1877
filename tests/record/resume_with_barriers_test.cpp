// Runs with barrier contact that are interrupted and resumed leave what those that were not leave.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/mission/reader.hpp"
#include "retiarius/record/checkpoint.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/run_file.hpp"
#include "tests/record/resumed_run.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using testing::Break;
using testing::expect_resumes;
using testing::expect_same_results;
using testing::resume_in;
using testing::ResumeCase;
using testing::run_into;
using testing::TemporaryFolder;

// A small net is drawn together, its threads touching each other, is shot at a tumbling box, and
// closed around it, with friction of both kinds.
std::string capture_by_barriers() {
  return R"(
[net]
pattern = "square"
side = 0.8
mesh = 0.2
segments = 2
disturbance = 1.0e-3

[net.thread]
young_modulus = 1.0e7
density = 1200.0
radius = 0.003
bending = "bounded"
bending_stiffness = 1.0e-5
compression = false
material_damping = 1.0e-3

[net.corner_mass]
mass = 0.05

[target]
shape = "box"
size = [0.3, 0.25, 0.2]
mass = 2.0
position = [0.0, 0.0, 0.4]
velocity = [0.0, 0.0, -0.2]
spin_deg = [60.0, 120.0, 30.0]

[integrator]
step = 0.005
max_iterations = 200

[contact]
method = "barrier"
self = true
friction = 0.3
thread_friction = 0.2
gap = 2.0e-3

[[phase]]
kind = "fold"
grips = "lattice"
grip_spacing = 0.4
ratio = 0.15
duration = 0.3
until = "phase_time >= 0.32"
[phase.environment]
gravity = [0.0, 0.0, -9.81]
damping = 2.0

[[phase]]
kind = "shoot"
speed = 4.0
half_angle_deg = 40.0
until = "phase_time >= 0.2"

[[phase]]
kind = "close"
delay = 0.01
distance = 0.2
radius = 0.2
speed = 2.0
until = "phase_time >= 0.12"

[output]
interval = 0.01
frame_interval = 0.05
)";
}

std::vector<ResumeCase> cases() {
  const auto method = [](const std::string& name) { return "integrator.method=" + name; };
  const std::string adaptive = "integrator.adaptive=true";
  return {
      {"implicit_euler", {method("implicit-euler")}},
      {"newmark", {method("newmark"), "integrator.step=0.001"}},
      {"midpoint",
       {method("midpoint"), "integrator.step=0.001", "net.thread.bending=none",
        "net.thread.young_modulus=1.0e6"}},
      {"generalised_alpha", {method("generalised-alpha"), "integrator.rho=0.5"}},
      {"tr_bdf2", {method("tr-bdf2")}},
      {"implicit_euler_adaptive", {method("implicit-euler"), adaptive}},
      {"generalised_alpha_adaptive", {method("generalised-alpha"), adaptive}},
      {"tr_bdf2_adaptive", {method("tr-bdf2"), adaptive}},
      {"many_rounds", {"contact.friction_rounds=30", "contact.friction_tolerance=1e-6"}},
      {"no_friction", {"contact.friction=0.0", "contact.thread_friction=0.0"}},
      {"not_itself", {"contact.self=false"}},
      {"fine_output", {"output.interval=0.005", "output.frame_interval=0.005"}},
  };
}

class ResumeWithBarriers : public ::testing::TestWithParam<ResumeCase> {};

TEST_P(ResumeWithBarriers, ACaptureLeavesWhatTheWholeRunLeaves) {
  const bool itself = std::string(GetParam().name) != "not_itself";
  const auto look = [&](const std::filesystem::path& folder) {
    const RunFile run(folder / "run.h5");
    const auto most = [&](const char* column) {
      const std::vector<double> rows = run.history(column);
      return *std::max_element(rows.begin(), rows.end());
    };
    EXPECT_GT(most("contacts_face") + most("contacts_edge"), 0.0);
    EXPECT_EQ(most("contacts_thread") > 0.0, itself);
  };
  expect_resumes(capture_by_barriers(), GetParam(), Outcome::finished, look);
}

INSTANTIATE_TEST_SUITE_P(Cases, ResumeWithBarriers, ::testing::ValuesIn(cases()), testing::name_of);

Mission mission(const std::vector<std::string>& overrides = {}) {
  return parse_mission(capture_by_barriers(), "mission", ".", overrides);
}

// Also after parts of steps that had to be cut, between which no trigger is tested.
TEST(ResumeWithBarriersOften, AfterEveryAcceptedStep) {
  const Mission coarse =
      mission({"integrator.step=0.02", "output.interval=0.02", "output.frame_interval=0.1"});
  const TemporaryFolder folder;
  run_into(folder / "whole", coarse);
  RunReport report = run_into(folder / "broken", coarse, {{Break::Kind::stopped, 1}});
  int within = 0;
  while (report.outcome == Outcome::interrupted) {
    const double time = read_checkpoint(folder / "broken").time;
    if (std::abs(std::remainder(time, 0.02)) > 1e-6) ++within;
    report = resume_in(folder / "broken", coarse, {{Break::Kind::stopped, 1}});
  }
  EXPECT_GT(within, 0);
  expect_same_results(folder / "whole", folder / "broken");
}

// The row at the end of a run that is stopped before its first step comes from the checkpoint
// alone.
TEST(ResumeWithBarriersOften, TheCheckpointKnowsTheContacts) {
  const TemporaryFolder folder;
  run_into(folder / "broken", mission(), {{Break::Kind::stopped, 81}});
  ASSERT_GT(RunFile(folder / "broken/run.h5").history("contact_energy").back(), 0.0);
  const std::string rows = read_whole_file(folder / "broken/history.csv");
  EXPECT_EQ(resume_in(folder / "broken", mission(), {{Break::Kind::stopped, 0}}).outcome,
            Outcome::interrupted);
  EXPECT_EQ(read_whole_file(folder / "broken/history.csv"), rows);
}

}  // namespace
}  // namespace retiarius

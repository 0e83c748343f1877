// Runs with barrier contact that are interrupted and resumed leave what those that were not leave.
#include <algorithm>
#include <array>
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
using testing::by_implicit_methods;
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

INSTANTIATE_TEST_SUITE_P(
    Cases, ResumeWithBarriers,
    ::testing::ValuesIn(by_implicit_methods(
        {{"many_rounds", {"contact.friction_rounds=30", "contact.friction_tolerance=1e-6"}},
         {"no_friction", {"contact.friction=0.0", "contact.thread_friction=0.0"}},
         {"not_itself", {"contact.self=false"}}})),
    testing::name_of);

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

// What is recorded of contact places adds up to what is recorded of the body.
TEST(ContactsOfFrames, SumUpToTheLoadOfTheBody) {
  const TemporaryFolder folder;
  const RunReport report = run_into(folder / "run", mission());
  const RunFile run(folder / "run/run.h5");
  const std::vector<double> times = run.history("time");
  std::array<std::vector<double>, 3> load;
  for (int k = 0; k < 3; ++k) load[k] = run.history(std::string("target.contact_f") + "xyz"[k]);
  const auto threads = static_cast<Index>(build_network(mission().net).threads.size());
  double largest = 0.0;
  for (std::size_t f = 0; f < run.frame_count(); ++f) {
    const FrameData frame = run.frame(f);
    Vec3 sum = Vec3::Zero();
    for (const ContactMark& mark : frame.contacts) {
      EXPECT_GE(mark.thread, 0);
      EXPECT_LT(mark.thread, threads);
      if (mark.body == kNone) continue;
      sum += mark.force;
      // On the box, which is as large as its corners are far.
      const Vec3 place = to_body(frame.bodies[0], mark.point).cwiseAbs();
      EXPECT_LT((place - Vec3(0.15, 0.125, 0.1)).maxCoeff(), 1e-9);
      EXPECT_GT((place - Vec3(0.15, 0.125, 0.1)).maxCoeff(), -1e-9);
    }
    const auto row = static_cast<std::size_t>(
        std::find_if(times.begin(), times.end(),
                     [&](double t) { return std::abs(t - frame.time) < 1e-9; }) -
        times.begin());
    ASSERT_LT(row, times.size());
    const Vec3 expected(load[0][row], load[1][row], load[2][row]);
    EXPECT_LE((sum - expected).norm(), 1e-9 * (1.0 + expected.norm()));
    largest = std::max(largest, expected.norm());
  }
  EXPECT_GT(largest, 0.0);
  const auto measured = [&](const std::string& name) {
    for (const Measure& m : report.measures)
      if (m.name == name) return m.value;
    return decltype(Measure::value){};
  };
  EXPECT_EQ(std::get<std::int64_t>(measured("first_contact_body")), 0);
  EXPECT_LT(std::get<std::int64_t>(measured("first_contact_thread")), threads);
  const Vec3 place(std::get<double>(measured("first_contact_x")),
                   std::get<double>(measured("first_contact_y")),
                   std::get<double>(measured("first_contact_z")));
  EXPECT_NEAR((place.cwiseAbs() - Vec3(0.15, 0.125, 0.1)).maxCoeff(), 0.0, 1e-9);
}

}  // namespace
}  // namespace retiarius

#include <gmock/gmock.h>

#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"

namespace retiarius {
namespace {

// Newmark on stiff tension-only threads whose axial waves are far from resolved (c h / l0 = 70)
// multiplies its energy although every step converges. Such a run must not end as finished.
TEST(MadeEnergy, EndsTheRunAsFailed) {
  const Mission mission = parse_mission(R"(
[net]
pattern = "square"
side = 1.0
mesh = 0.2
segments = 2
scale = 0.5
zigzag = true
[net.thread]
young_modulus = 70.0e9
density = 1390.0
radius = 0.0005
compression = false
[net.corner_mass]
mass = 0.1
[integrator]
method = "newmark"
step = 0.001
[[phase]]
kind = "shoot"
speed = 5.0
half_angle_deg = 60.0
until = "time >= 1.0"
)");
  const MissionModel model(mission);
  Observer silent;
  const RunReport report = run_mission(mission, model, silent);
  EXPECT_EQ(report.outcome, Outcome::failed);
  EXPECT_THAT(report.reason, ::testing::AnyOf(::testing::HasSubstr("from nothing"),
                                              ::testing::HasSubstr("does not converge")));
}

}  // namespace
}  // namespace retiarius

// What happens at a certain time within a phase, against the grid of steps.
#include <cmath>

#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// The corner masses leave 0.05 s after 0.1 s, which as a sum of doubles is one rounding later than
// the 60th step of 0.0025 s.
const char* const kLateShot = R"(
[net]
pattern = "square"
side = 1.0
mesh = 0.25

[net.thread]
young_modulus = 1.0e8
density = 1000.0
radius = 0.001
compression = false

[integrator]
step = 0.0025

[[phase]]
kind = "free"
until = "time >= 0.1"

[[phase]]
kind = "shoot"
speed = 2.0
half_angle_deg = 0.0
delay = 0.05
until = "time >= 0.2"
)";

TEST(Events, OneRoundingAfterAStepIsThatStep) {
  ASSERT_GT(0.1 + 0.05, 60 * 0.0025);
  const RecordedRun run = run_text(kLateShot);
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  EXPECT_EQ(run.last.step, 80);
  EXPECT_EQ(run.rows.size(), 21u);
  // The shot has its full momentum, and the net has kept it.
  double bullets = 0.0;
  for (Index b : run.model.network.bullets) bullets += run.model.network.mass[b];
  EXPECT_EQ(run.at(0.14).momentum.z(), 0.0);
  EXPECT_NEAR(run.rows.back().momentum.z(), 2.0 * bullets, 1e-12);
}

// Between steps the run stops for it.
TEST(Events, BetweenStepsCutAStep) {
  const RecordedRun run = run_text(kLateShot, {"phase[1].delay=0.0512"});
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  EXPECT_EQ(run.last.step, 81);
  EXPECT_EQ(run.rows.size(), 21u);
  const Index corner = run.model.network.corners[0];
  EXPECT_GT(run.last.x[corner].z(), 0.05);
}

}  // namespace
}  // namespace retiarius

// Adaptive steps in a whole mission: rows, events and the record of step sizes.
#include <cmath>

#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// The step does not divide the interval, and the phases end between rows.
const char* const kShot = R"(
[net]
pattern = "square"
side = 1.0
mesh = 0.25
segments = 2
scale = 0.6
zigzag = true
[net.thread]
young_modulus = 1.0e7
density = 1000.0
radius = 0.002
compression = false
[net.corner_mass]
mass = 0.1
[target]
shape = "sphere"
radius = 0.2
mass = 5.0
position = [0.0, 0.0, 0.25]
[contact]
method = "modified-mass"
friction = 0.3
[integrator]
step = 0.0037
adaptive = true
accuracy = 1.0e-3
[output]
interval = 0.01
frame_interval = 0.05
[[phase]]
kind = "shoot"
speed = 4.0
half_angle_deg = 40.0
delay = [0.0, 0.0123, 0.0, 0.0]
until = "time >= 0.0555"
[[phase]]
kind = "contact"
until = "time >= 0.15"
)";

class AdaptiveMission : public ::testing::TestWithParam<const char*> {};

TEST_P(AdaptiveMission, HitsRowsAndEventsThroughSnapsAndContact) {
  const std::string method = std::string("integrator.method=") + GetParam();
  const RecordedRun run = run_text(kShot, {method});
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  EXPECT_NEAR(run.report.phases[0].end, 0.0555, 1e-12);
  EXPECT_NEAR(run.last.time, 0.15, 1e-12);
  ASSERT_EQ(run.rows.size(), 16u);
  double smallest = 1.0, largest = 0.0;
  for (std::size_t k = 0; k < run.rows.size(); ++k) {
    EXPECT_NEAR(run.rows[k].time, 0.01 * static_cast<double>(k), 1e-12);
    if (k == 0) continue;
    smallest = std::min(smallest, run.rows[k].step_size);
    largest = std::max(largest, run.rows[k].step_size);
  }
  EXPECT_EQ(run.rows[0].step_size, 0.0);
  EXPECT_GT(smallest, 0.0);
  EXPECT_LE(largest, 0.0037 * 1.0001);
  EXPECT_LT(smallest, 0.7 * largest);
  EXPECT_LE(number(run.report.measures, "linear_momentum_drift"), 1e-9);
  EXPECT_GT(number(run.report.measures, "first_contact_time"), 0.0);

  const RecordedRun again = run_text(kShot, {method});
  EXPECT_EQ(run.last.step, again.last.step);
  EXPECT_EQ(run.last.x, again.last.x);
}

INSTANTIATE_TEST_SUITE_P(Integrators, AdaptiveMission,
                         ::testing::Values("implicit-euler", "newmark", "tr-bdf2"),
                         [](const auto& method) {
                           std::string name = method.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace retiarius

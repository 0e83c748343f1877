// A net that falls onto a fixed ball.
#include <cmath>

#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

TEST(DropOnSphere, TheBallCatchesTheNet) {
  const RecordedRun run = run_file("drop-on-sphere");
  expect_sound(run);
  const Measures& m = run.report.measures;

  // The net starts 5 cm above the ball: free fall takes sqrt(2 s / g), less the thread's radius,
  // and a little more with damping.
  const double fall = std::sqrt(2.0 * (0.05 - 0.004) / 9.81);
  EXPECT_NEAR(number(m, "first_contact_time"), fall, 0.01);
  EXPECT_GT(run.rows.back().contacts, 20);

  // The net hangs on the ball: it hardly moves, at one radius of thread above the ball's top.
  EXPECT_LT(run.rows.back().kinetic_energy, 0.01 * energy_turned_over(run.rows));
  EXPECT_NEAR(run.rows.back().probes[0].position.z(), 0.304, 0.002);

  // Nodes stay outside; a straight segment of length l between two of them dips l^2 / (8 R) into
  // a ball of radius R.
  const double l = 0.05 * (1.0 + number(m, "peak_strain"));
  EXPECT_GT(number(m, "smallest_distance"), -l * l / (8.0 * 0.304) - 1e-4);

  EXPECT_LT(number(m, "linear_momentum_drift"), 1e-9);
  EXPECT_GT(run.rows.back().friction_loss, 0.0);
  EXPECT_GT(run.rows.back().impact_loss, 0.0);
}

}  // namespace
}  // namespace retiarius

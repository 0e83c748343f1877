// Where the energy is convex, implicit Euler only takes energy.
#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// Threads that only pull have an energy that is convex in the nodes' positions: each step then
// loses at least the kinetic energy of its change of velocity.
const char* const kPullingNet = R"(
[net]
pattern = "hexagon"
side = 2.0
mesh = 0.5
segments = 2
scale = 0.3

[net.thread]
young_modulus = 1.0e8
density = 1000.0
radius = 0.001
compression = false

[net.corner_mass]
mass = 0.3

[integrator]
step = 0.005
tolerance = 1e-10

[[phase]]
kind = "shoot"
speed = 4.0
half_angle_deg = 40.0
until = "time >= 2.0"

[output]
interval = 0.005
)";

TEST(ConvexMission, ImplicitEulerNeverMakesEnergy) {
  const RecordedRun run = run_text(kPullingNet);
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  ASSERT_EQ(run.rows.size(), 401u);
  const double rounding = 1e-12 * run.rows.front().kinetic_energy;
  for (std::size_t k = 1; k < run.rows.size(); ++k)
    EXPECT_GE(run.rows[k].integrator_loss, run.rows[k - 1].integrator_loss - rounding)
        << "at " << run.rows[k].time << " s";
  EXPECT_GT(run.rows.back().integrator_loss, 0.01 * run.rows.front().kinetic_energy);
}

}  // namespace
}  // namespace retiarius

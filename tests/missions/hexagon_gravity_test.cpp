// The hexagon net under gravity of Huang et al. (2022), section 3.1.
#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

struct Height {
  double time;  // s
  double z;     // m
};

// Height of the centre, computed independently with implicit Euler at h = 0.01 s and converged
// Newton iterations; the six decimals are those of the reference. Later the motion of this net
// amplifies rounding.
constexpr Height kHeights[] = {
    {0.05, -0.074825}, {0.10, -0.273698}, {0.15, -0.559344}, {0.20, -0.643201}, {0.25, -0.434544},
    {0.30, -0.253291}, {0.35, -0.205719}, {0.40, -0.306743}, {0.50, -0.562176}, {0.55, -0.469970},
    {0.60, -0.369253}, {0.70, -0.386874}, {0.80, -0.494854}, {0.90, -0.410295}, {1.00, -0.410133},
    {1.10, -0.466735}, {1.20, -0.422524}, {1.40, -0.450930}, {1.50, -0.428884}};

TEST(HexagonGravity, CentreFollowsTheReference) {
  const RecordedRun run = run_file("hexagon-gravity");
  expect_sound(run);
  ASSERT_EQ(run.mission.probes[0].name, "center");
  for (const Height& h : kHeights)
    EXPECT_NEAR(run.at(h.time).probes[0].position.z(), h.z, 1e-5) << "at " << h.time << " s";
  EXPECT_NEAR(run.report.phases[0].end, 2.0, 1e-9);
  EXPECT_LT(number(run.report.measures, "linear_momentum_drift"), 1e-9);
}

// From the flat, unstrained net at once to where it comes to rest. Corner forces: a sixth of the
// weight of 11.309734 kg at 50 m/s2 each way up, and outward as computed independently.
TEST(HexagonGravity, StaticSolutionIsTheReference) {
  const RecordedRun run = run_file("hexagon-gravity", {"integrator.method=static"});
  EXPECT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  ASSERT_EQ(run.rows.size(), 1u);
  const HistoryRow& row = run.rows.front();
  EXPECT_EQ(row.time, 0.0);
  EXPECT_NEAR(row.probes[0].position.z(), -0.43500957, 1e-6 * 0.435);
  EXPECT_NEAR(row.peak_strain, 0.1722447640, 1e-6 * 0.1722);
  ASSERT_EQ(run.mission.probes[1].name, "corner0");
  EXPECT_NEAR(row.probes[1].force.z(), 94.247780, 1e-6 * 94.2);
  EXPECT_NEAR(row.probes[1].force.x(), 97.21597, 1e-6 * 97.2);  // corner 0 lies on +x
  EXPECT_NEAR(row.probes[1].force.y(), 0.0, 1e-6 * 97.2);
}

}  // namespace
}  // namespace retiarius

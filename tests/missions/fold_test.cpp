// Folding on the ground: the bundle's size and where the grips end.
#include <cmath>

#include <gmock/gmock.h>

#include "retiarius/mission/grips.hpp"
#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

TEST(Fold, LeavesABundleOfTheExpectedSize) {
  const RecordedRun run = run_file("fold");
  expect_sound(run);
  const PhaseSpec& phase = run.mission.phases[0];
  const Network& net = run.model.network;
  const double side = run.mission.net.side;
  const double r = run.mission.net.thread.radius;
  ASSERT_EQ(run.last.x.size(), net.design.size());

  // All grips have come together in one proportion about the centre, at their height.
  const std::vector<Index> grips = choose_grips(phase, net);
  EXPECT_EQ(grips.size(), 1u + 3u * 8u * 9u);  // a lattice of 0.5 m in a hexagon of 4 m
  for (Index g : grips)
    EXPECT_LT((run.last.x[g] - phase.ratio * net.design[g]).norm(), 1e-9) << "grip " << g;

  const Measures& m = run.report.phases[0].measures;
  EXPECT_NEAR(number(m, "bundle_diameter"), phase.ratio * 2.0 * side + 2.0 * r, 1e-6);
  // Half-way between two grips, which end 4 cm apart, a loop's lowest knot hangs one piece below
  // them; from such knots hang those of the lines without grips, one piece further down.
  const double mesh = run.mission.net.mesh;
  const double apart = phase.ratio * phase.grip_spacing;
  const double loop = std::sqrt(mesh * mesh - 0.25 * apart * apart);
  EXPECT_NEAR(number(m, "bundle_height"), 2.0 * loop + 2.0 * r, 0.01 * loop);
  // Volume of thread over that of the cylinder.
  const double n = side / mesh;
  const double length = mesh * (6.0 * n * n + 6.0 * n);
  const double d = number(m, "bundle_diameter");
  EXPECT_NEAR(number(m, "packing_ratio"),
              r * r * length / (0.25 * d * d * number(m, "bundle_height")), 1e-9);

  // Folding does not stretch: what hangs weighs little.
  EXPECT_LT(number(m, "peak_strain"), 1e-3);
  EXPECT_LT(run.rows.back().kinetic_energy, 0.05 * energy_turned_over(run.rows));
}

}  // namespace
}  // namespace retiarius

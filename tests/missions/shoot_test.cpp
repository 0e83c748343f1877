// Nets that are shot: how they spread.
#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// The widest mouth of a net of 10 m side shot at 20 m/s, as an independent model of the same net
// gives it: time, area over that of the flat net, travel of the corners.
struct Widest {
  double angle_deg, time, ratio, travel;
};

void expect_widest(const Widest& expected) {
  const RecordedRun run =
      run_file("shoot", {"phase[0].half_angle_deg=" + std::to_string(expected.angle_deg)});
  expect_sound(run);
  const Measures& m = run.report.measures;
  EXPECT_NEAR(number(m, "mouth_area_flat"), 259.81, 0.01);
  EXPECT_NEAR(number(m, "mouth_area_max_time"), expected.time, 0.05 * expected.time);
  EXPECT_NEAR(number(m, "mouth_area_max") / number(m, "mouth_area_flat"), expected.ratio,
              0.05 * expected.ratio);
  EXPECT_NEAR(number(m, "mouth_area_max_travel"), expected.travel, 0.05 * expected.travel);
  EXPECT_LT(number(m, "linear_momentum_drift"), 1e-9);
}

TEST(Shoot, WidestMouthAt30Degrees) { expect_widest({30.0, 1.176, 1.083, 17.94}); }
TEST(Shoot, WidestMouthAt45Degrees) { expect_widest({45.0, 0.846, 1.104, 10.47}); }

}  // namespace
}  // namespace retiarius

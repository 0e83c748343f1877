// A spread net closes around a ball and stays shut.
#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

TEST(Close, TheNetStaysShutAroundTheBall) {
  const RecordedRun run = run_file("close");
  expect_sound(run);
  const Measures& m = run.report.measures;
  EXPECT_TRUE(flag(m, "closed"));
  EXPECT_TRUE(flag(m, "success")) << "captured_share " << number(m, "captured_share");
  // The history tells how it came to be held.
  ASSERT_TRUE(run.rows.front().captured_share);
  EXPECT_EQ(*run.rows.front().captured_share, 0.0);
  EXPECT_EQ(*run.rows.back().captured_share, number(m, "captured_share"));
  EXPECT_LT(number(m, "mouth_width_final"), 0.1 * number(m, "mouth_width_flat"));
  EXPECT_LT(number(m, "linear_momentum_drift"), 1e-9);

  // The ball comes 9.6 cm at 1 m/s before it touches.
  EXPECT_NEAR(number(m, "first_contact_time"), 0.096, 0.006);
  ASSERT_EQ(run.report.phases.size(), 3u);
  EXPECT_EQ(run.report.phases[0].trigger, "contact or time >= 0.5");
  EXPECT_TRUE(flag(run.report.phases[1].measures, "released"));
  EXPECT_GT(run.rows.back().time - run.report.phases[2].start, 0.5);
}

// Without closing, the same net does not stay shut: the measure can fail.
TEST(Close, WithoutClosingTheMouthStaysOpen) {
  const RecordedRun run = run_file("close", {"phase[1].until=phase_time >= 0.04"});
  EXPECT_FALSE(flag(run.report.measures, "closed"));
  EXPECT_FALSE(flag(run.report.measures, "success"));
}

}  // namespace
}  // namespace retiarius

// The whole capture mission as it stands in missions/capture.toml takes minutes: it runs where the
// environment variable RETIARIUS_FULL is set.
#include <cstdlib>

#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

TEST(CaptureFull, CatchesTheSatellite) {
  if (std::getenv("RETIARIUS_FULL") == nullptr)
    GTEST_SKIP() << "set RETIARIUS_FULL to run the whole mission, which takes minutes";
  const RecordedRun run = run_file("capture");
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  expect_sound(run);
  const Measures& m = run.report.measures;
  EXPECT_TRUE(flag(m, "success")) << "captured_share " << number(m, "captured_share");
  EXPECT_TRUE(flag(m, "closed"));
  EXPECT_LT(number(m, "linear_momentum_drift"), 1e-9);
}

}  // namespace
}  // namespace retiarius

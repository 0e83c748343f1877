// The whole capture mission, on a coarse net and with short phases: every phase runs and hands on
// to the next.
#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

TEST(Capture, AllPhasesRunOnACoarseNet) {
  const RecordedRun run =
      run_file("capture", {"net.mesh=0.4", "net.segments=1", "phase[0].grip_spacing=0.8"});
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  expect_sound(run);
  ASSERT_EQ(run.report.phases.size(), 5u);
  const PhaseKind kinds[] = {PhaseKind::fold, PhaseKind::shoot, PhaseKind::spread, PhaseKind::close,
                             PhaseKind::contact};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(run.report.phases[k].kind, kinds[k]);
    EXPECT_EQ(run.report.phases[k].start, k == 0 ? 0.0 : run.report.phases[k - 1].end);
  }
  const Measures& m = run.report.measures;
  EXPECT_LT(number(m, "linear_momentum_drift"), 1e-9);
  EXPECT_GT(number(m, "first_contact_time"), run.report.phases[1].start);
  EXPECT_GT(number(run.report.phases[0].measures, "packing_ratio"), 0.0);
}

}  // namespace
}  // namespace retiarius

// What the stiff net of missions/stiff-capture.toml must show up to 2 s, at any step.
#pragma once

#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius::testing {

inline void expect_stiff_capture(const std::string& step) {
  const RecordedRun run =
      run_file("stiff-capture", {"phase[0].until=time >= 2.0", "integrator.step=" + step});
  expect_sound(run);
  EXPECT_NEAR(run.last.time, 2.0, 1e-9);
  const Measures& m = run.report.measures;
  // Mouth areas of a converged explicit computation.
  EXPECT_NEAR(run.at(1.0).mouth_area, 10.55, 0.03 * 10.55);
  EXPECT_NEAR(run.at(1.5).mouth_area, 16.89, 0.03 * 16.89);
  EXPECT_LT(number(m, "peak_strain"), 2e-3);
  EXPECT_GT(number(m, "peak_strain"), 1e-6);
  EXPECT_LT(number(m, "linear_momentum_drift"), 1e-9);
}

}  // namespace retiarius::testing

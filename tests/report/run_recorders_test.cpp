#include "retiarius/report/run_recorders.hpp"

#include <gtest/gtest.h>

#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

TEST(MakeRunRecorders, LeaveTheReportBesideTheRecords) {
  testing::TemporaryFolder base;
  const testing::SampleRun run;
  const auto recorders = make_run_recorders(base / "out", {});
  run.feed(*recorders, 3);
  recorders->end(run.report(Outcome::interrupted));
  EXPECT_TRUE(std::filesystem::exists(base / "out/report.html"));
  EXPECT_TRUE(std::filesystem::exists(base / "out/run.h5"));
}

}  // namespace
}  // namespace retiarius

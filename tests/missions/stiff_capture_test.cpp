#include "tests/missions/stiff_capture.hpp"

namespace retiarius {
namespace {

TEST(StiffCapture, RunsAtTheLargeStep) { testing::expect_stiff_capture("0.005"); }

}  // namespace
}  // namespace retiarius

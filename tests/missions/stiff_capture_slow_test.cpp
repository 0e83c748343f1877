#include "tests/missions/stiff_capture.hpp"

namespace retiarius {
namespace {

TEST(StiffCaptureSlow, RunsAtTheSmallStep) { testing::expect_stiff_capture("0.001"); }

}  // namespace
}  // namespace retiarius

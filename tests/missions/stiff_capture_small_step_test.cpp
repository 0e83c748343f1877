#include "tests/missions/stiff_capture.hpp"

namespace retiarius {
namespace {

TEST(StiffCapture, RunsAtTheSmallStep) { testing::expect_stiff_capture("0.001"); }

}  // namespace
}  // namespace retiarius

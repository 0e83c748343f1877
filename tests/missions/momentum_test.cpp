// What is conserved when a soft net meets a free ball.
#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

const char* const kSoftNet = R"(
[net]
pattern = "square"
side = 1.0
mesh = 0.2
segments = 2
scale = 0.9

[net.thread]
young_modulus = 1.0e6
density = 1000.0
radius = 0.005

[net.corner_mass]
mass = 0.2

[target]
shape = "sphere"
radius = 0.25
mass = 10.0
position = [0.05, 0.02, 0.35]
spin_deg = [10.0, 20.0, -5.0]

[integrator]
step = 0.001

[contact]
method = "modified-mass"
friction = 0.3

[[phase]]
kind = "shoot"
speed = 3.0
half_angle_deg = 20.0
until = "time >= 0.3"
)";

class SoftNet : public ::testing::TestWithParam<const char*> {};

TEST_P(SoftNet, LinearMomentumIsConstantThroughContact) {
  const RecordedRun run = run_text(kSoftNet, {std::string("integrator.method=") + GetParam()});
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  EXPECT_LE(number(run.report.measures, "linear_momentum_drift"), 1e-9);
  // The net has hit the ball and pushed it.
  EXPECT_GT(number(run.report.measures, "first_contact_time"), 0.0);
  EXPECT_GT(run.last.bodies[0].velocity.z(), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Integrators, SoftNet,
                         ::testing::Values("implicit-euler", "newmark", "midpoint",
                                           "generalised-alpha", "tr-bdf2"),
                         [](const auto& method) {
                           std::string name = method.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

TEST(SoftNetAlone, MidpointKeepsAngularMomentumBeforeContact) {
  const std::vector<std::string> early = {"integrator.method=midpoint",
                                          "phase[0].until=time >= 0.05",
                                          // A net that turns: one corner mass leaves faster.
                                          "phase[0].speed=[3.0, 3.5, 2.0, 3.0]"};
  const RecordedRun run = run_text(kSoftNet, early);
  ASSERT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  for (const HistoryRow& row : run.rows) EXPECT_EQ(row.contacts, 0);
  EXPECT_LE(number(run.report.measures, "angular_momentum_drift"), 1e-9);

  // Implicit Euler loses some at its order: the measure sees it.
  std::vector<std::string> by_euler = early;
  by_euler[0] = "integrator.method=implicit-euler";
  EXPECT_GT(number(run_text(kSoftNet, by_euler).report.measures, "angular_momentum_drift"), 1e-9);
}

}  // namespace
}  // namespace retiarius

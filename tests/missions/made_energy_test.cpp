#include <string>

#include <gmock/gmock.h>

#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"

namespace retiarius {
namespace {

// Newmark on stiff tension-only threads whose axial waves are far from resolved (c h / l0 = 70)
// multiplies its energy although every step converges. Such a run must not end as finished.
TEST(MadeEnergy, EndsTheRunAsFailed) {
  const Mission mission = parse_mission(R"(
[net]
pattern = "square"
side = 1.0
mesh = 0.2
segments = 2
scale = 0.5
zigzag = true
[net.thread]
young_modulus = 70.0e9
density = 1390.0
radius = 0.0005
compression = false
[net.corner_mass]
mass = 0.1
[integrator]
method = "newmark"
step = 0.001
[[phase]]
kind = "shoot"
speed = 5.0
half_angle_deg = 60.0
until = "time >= 1.0"
)");
  const MissionModel model(mission);
  Observer silent;
  const RunReport report = run_mission(mission, model, silent);
  EXPECT_EQ(report.outcome, Outcome::failed);
  EXPECT_THAT(report.reason, ::testing::HasSubstr("from nothing"));
}

// The same net at a tenth of the step, c h / l0 = 7: Newmark still makes hundreds of joules of five
// within 50 ms; what TR-BDF2 and generalised alpha with rho = 0 make is far below what moves.
RunReport shot(const std::string& integrator, double* loss) {
  class Last : public Observer {
   public:
    void history(const HistoryRow& row) override { loss = row.integrator_loss; }
    double loss = 0.0;
  };
  const Mission mission = parse_mission(R"(
[net]
pattern = "square"
side = 1.0
mesh = 0.2
segments = 2
scale = 0.5
zigzag = true
[net.thread]
young_modulus = 70.0e9
density = 1390.0
radius = 0.0005
compression = false
[net.corner_mass]
mass = 0.1
[integrator]
step = 0.0001
)" + integrator + R"(
[[phase]]
kind = "shoot"
speed = 5.0
half_angle_deg = 60.0
until = "time >= 0.06"
)");
  const MissionModel model(mission);
  Last last;
  const RunReport report = run_mission(mission, model, last);
  *loss = last.loss;
  return report;
}

TEST(MadeEnergy, IsNoneWhereTheSchemeDampsWhatItDoesNotResolve) {
  double loss = 0.0;
  EXPECT_EQ(shot("method = \"newmark\"", &loss).outcome, Outcome::failed);
  EXPECT_LT(loss, -5.0);
  for (const char* method : {"method = \"tr-bdf2\"", "method = \"generalised-alpha\"\nrho = 0.0"}) {
    EXPECT_EQ(shot(method, &loss).outcome, Outcome::finished) << method;
    EXPECT_GT(loss, -0.05) << method;  // J, of 5 J shot
  }
}

// A net at rest away from the origin has nothing but the rounding of its strains, which is no
// failure of any integrator.
TEST(MadeEnergy, RestIsNotMistakenForIt) {
  for (const char* method :
       {"implicit-euler", "newmark", "midpoint", "generalised-alpha", "tr-bdf2"}) {
    const Mission mission = parse_mission(std::string(R"(
[net]
pattern = "hexagon"
side = 1.0
mesh = 0.2
segments = 2
position = [3.0, 1.0, 7.0]
[net.thread]
young_modulus = 1.0e9
density = 1000.0
radius = 0.001
[output]
interval = 0.001
frame_interval = 0.1
[integrator]
step = 0.001
method = ")") + method + R"("
[[phase]]
kind = "free"
until = "time >= 0.05"
)");
    const MissionModel model(mission);
    Observer silent;
    const RunReport report = run_mission(mission, model, silent);
    EXPECT_EQ(report.outcome, Outcome::finished) << method << ": " << report.reason;
  }
}

}  // namespace
}  // namespace retiarius

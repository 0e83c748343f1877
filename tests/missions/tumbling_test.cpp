// A target that tumbles freely, through a whole mission.
#include <cmath>

#include <gmock/gmock.h>

#include "tests/missions/recorded_run.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// Spins about the axis of its middle moment, (0.01, 1, 0) rad/s; the net is one cell, at rest far
// away.
const char* const kTumbling = R"(
[net]
pattern = "triangle"
side = 1.0
mesh = 1.0
position = [1000.0, 0.0, 0.0]

[net.thread]
young_modulus = 1.0e6
density = 1000.0
radius = 0.001

[target]
shape = "box"
size = [1.0, 1.0, 1.0]
mass = 1.0
inertia = [1.0, 2.0, 3.0]
spin_deg = [0.57295779513082321, 57.295779513082321, 0.0]

[integrator]
step = 0.01

[[phase]]
kind = "free"
until = "time >= 209.0"

[output]
interval = 0.5
frame_interval = 1.0
)";

// Notes when the second spin component changes sign, interpolated between steps.
class SpinWatch final : public Observer {
 public:
  explicit SpinWatch(const Body& body) : body_(body) {}
  void history(const HistoryRow& row) override { energies.push_back(row.kinetic_energy); }
  void progress(const State& state, Index, double) override {
    const BodyState& s = state.bodies[0];
    const double w = (s.attitude.conjugate() * spin(body_, s)).y();
    if (time_ > 0.0 && w * w_ < 0.0) flips.push_back(time_ + (state.time - time_) * w_ / (w_ - w));
    time_ = state.time;
    w_ = w;
  }

  std::vector<double> energies;
  std::vector<double> flips;

 private:
  const Body& body_;
  double time_ = 0.0, w_ = 0.0;
};

TEST(Tumbling, FlipsInTimeAndKeepsItsEnergy) {
  const Mission mission = parse_mission(kTumbling);
  const MissionModel model(mission);
  SpinWatch watch(model.bodies[0]);
  const RunReport report = run_mission(mission, model, watch);
  ASSERT_EQ(report.outcome, Outcome::finished) << report.reason;
  // Sign changes follow each other at the half period of Euler's equations, 20.75461 s, the first
  // after half of it.
  ASSERT_EQ(watch.flips.size(), 10u);
  EXPECT_NEAR(watch.flips[0], 10.3773, 0.02);
  EXPECT_NEAR(watch.flips[1], 31.1319, 0.02);
  EXPECT_NEAR(watch.flips[2], 51.8865, 0.02);
  for (std::size_t k = 1; k < watch.flips.size(); ++k)
    EXPECT_NEAR(watch.flips[k] - watch.flips[k - 1], 20.75461, 0.02) << "flip " << k;
  const double energy = 0.5 * (1.0 * 0.01 * 0.01 + 2.0 * 1.0);
  for (const double e : watch.energies) EXPECT_NEAR(e, energy, 1e-6 * energy);
}

}  // namespace
}  // namespace retiarius

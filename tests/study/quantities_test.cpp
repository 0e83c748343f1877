#include "retiarius/study/quantities.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "tests/study/small_nets.hpp"

namespace retiarius {
namespace {

using testing::falling_net;

RunReport report() {
  RunReport r;
  r.measures = {{"mouth_width_flat", "m", 2.0},
                {"peak_tension", "N", 7.0},
                {"first_contact_time", "s", std::monostate{}},
                {"linear_momentum_drift", "", 1e-15},
                {"closed", "", true},
                {"steps", "", std::int64_t{12}}};
  r.phases.resize(2);
  for (PhaseReport& phase : r.phases) {
    phase.name = "free";
    phase.end = 0.5;
    phase.measures = {{"peak_tension", "N", 3.0}};
  }
  return r;
}

std::vector<HistoryRow> rows() {
  std::vector<HistoryRow> two(2);
  two[0].kinetic_energy = 40.0;
  two[1].kinetic_energy = 4.0;
  two[1].gravity_energy = -1.0;
  for (HistoryRow& row : two) row.probes = {{Vec3(1, 2, 3), Vec3::Zero()}};
  return two;
}

TEST(RunQuantities, HoldMeasuresEnergiesProbesAndPhases) {
  const auto all = run_quantities(falling_net(), report(), rows());
  EXPECT_EQ(find_quantity(all, "peak_tension")->value, 7.0);
  EXPECT_EQ(find_quantity(all, "closed")->unit, "yes/no");
  EXPECT_EQ(find_quantity(all, "closed")->value, 1.0);
  EXPECT_TRUE(std::isnan(find_quantity(all, "first_contact_time")->value));
  EXPECT_EQ(find_quantity(all, "center.y")->value, 2.0);
  EXPECT_EQ(find_quantity(all, "phase[1].free.end")->value, 0.5);
  EXPECT_EQ(find_quantity(all, "phase[0].free.peak_tension")->value, 3.0);
}

TEST(RunQuantities, LeaveOutWhatIsNoResult) {
  const auto all = run_quantities(falling_net(), report(), rows());
  EXPECT_EQ(find_quantity(all, "steps"), nullptr);
  EXPECT_EQ(find_quantity(all, "mouth_width_flat"), nullptr);
  EXPECT_EQ(find_quantity(all, "bending_energy_final"), nullptr);  // no bending in this mission
}

TEST(RunQuantities, KnowWhatSmallNumbersAreSmallBeside) {
  const auto all = run_quantities(falling_net(), report(), rows());
  EXPECT_EQ(find_quantity(all, "center.x")->size, 2.0);
  EXPECT_EQ(find_quantity(all, "kinetic_energy_final")->size, 40.0);
  EXPECT_EQ(find_quantity(all, "linear_momentum_drift")->size, 1.0);
}

}  // namespace
}  // namespace retiarius

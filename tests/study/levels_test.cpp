#include "retiarius/study/levels.hpp"

#include <gmock/gmock.h>

#include "retiarius/mission/run.hpp"
#include "tests/study/small_nets.hpp"

namespace retiarius {
namespace {

using ::testing::ElementsAre;
using testing::falling_net;
using ::testing::HasSubstr;

std::string refusal(const Mission& mission, int count, Vary vary) {
  try {
    plan_levels(mission, count, vary);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PlanLevels, HalvesStepsAndDoublesSegments) {
  const Plan plan = plan_levels(falling_net(), 3, Vary::both);
  ASSERT_EQ(plan.levels.size(), 5u);
  ASSERT_EQ(plan.series.size(), 2u);
  EXPECT_THAT(plan.series[0].levels, ElementsAre(0u, 1u, 2u));
  EXPECT_THAT(plan.series[1].levels, ElementsAre(0u, 3u, 4u));
  EXPECT_THAT(plan.series[0].sizes, ElementsAre(1e-3, 5e-4, 2.5e-4));
  EXPECT_THAT(plan.series[1].sizes, ElementsAre(0.25, 0.125, 0.0625));
  EXPECT_EQ(plan.levels[2].mission.phases[0].integrator.step, 2.5e-4);
  EXPECT_EQ(plan.levels[2].mission.net.segments, 2);
  EXPECT_EQ(plan.levels[4].mission.phases[0].integrator.step, 1e-3);
  EXPECT_EQ(plan.levels[4].mission.net.segments, 8);
  EXPECT_EQ(plan.levels[2].name, "h = 0.00025 s");
  EXPECT_EQ(plan.levels[4].name, "8 segments a piece");
}

TEST(PlanLevels, KnowsWhatTheRunsWillCost) {
  const Plan plan = plan_levels(falling_net(), 3, Vary::step);
  EXPECT_EQ(plan.levels[0].steps, 100.0);
  EXPECT_EQ(plan.levels[2].steps, 400.0);
  EXPECT_DOUBLE_EQ(plan.cost(), 7.0);
  const Plan mesh = plan_levels(falling_net(), 2, Vary::mesh);
  EXPECT_EQ(mesh.levels[0].nodes, 55.0);
  EXPECT_DOUBLE_EQ(mesh.cost(), 1.0 + mesh.levels[1].nodes / 55.0);
  EXPECT_EQ(
      plan_levels(falling_net({"phase[0].until=mouth_area < 1"}), 2, Vary::step).levels[0].steps,
      0.0);
}

TEST(PlanLevels, RefinesEveryPhaseAndTheBridles) {
  const Mission mission =
      falling_net({"phase[0].integrator.step=0.0005", "net.corner_mass.mass=1",
                   "net.corner_mass.bridle=0.5", "net.corner_mass.bridle_segments=3"});
  const Plan plan = plan_levels(mission, 2, Vary::both);
  EXPECT_EQ(plan.levels[1].mission.phases[0].integrator.step, 2.5e-4);
  EXPECT_EQ(plan.levels[2].mission.net.corner_mass.bridle_segments, 6);
}

TEST(PlanLevels, RefusesOrLeavesOutWhatCannotBeVaried) {
  const Mission rest = falling_net({"integrator.method=static"});
  EXPECT_EQ(refusal(rest, 3, Vary::step),
            "every phase is solved statically, so there is no step to halve");
  const Plan plan = plan_levels(rest, 3, Vary::both);
  ASSERT_EQ(plan.series.size(), 1u);
  EXPECT_EQ(plan.series[0].vary, Vary::mesh);
  EXPECT_THAT(plan.notes, ElementsAre(HasSubstr("no step to halve")));

  Mission saved = falling_net();
  saved.net.state = "elsewhere";
  EXPECT_THAT(refusal(saved, 3, Vary::mesh), HasSubstr("net.state gives the places"));
  EXPECT_THAT(refusal(falling_net(), 1, Vary::both), HasSubstr("2 to 10 levels, not 1"));
}

// Node 40 lies inside a piece and would be elsewhere in a finer mesh; node 3 is a knot and stays.
TEST(PlanLevels, NoticesIndicesThatAFinerMeshMoves) {
  EXPECT_THAT(refusal(falling_net({"probe[0].node=40"}), 3, Vary::mesh),
              HasSubstr("node 40 lies inside a piece"));
  EXPECT_EQ(refusal(falling_net({"probe[0].node=3"}), 3, Vary::mesh), "");
}

}  // namespace
}  // namespace retiarius

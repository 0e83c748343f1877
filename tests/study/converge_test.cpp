#include "retiarius/study/converge.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "tests/study/small_nets.hpp"

namespace retiarius {
namespace {

using testing::falling_net;
using ::testing::HasSubstr;

const Trend& trend(const SeriesResult& result, const std::string& name) {
  for (const Trend& t : result.trends)
    if (t.name == name) return t;
  throw Error("no trend " + name);
}

// Implicit Euler is of first order in the step, the trapezoid of second.
TEST(Converge, FindsTheOrderOfTheIntegrators) {
  const Study euler = converge(plan_levels(falling_net(), 4, Vary::step));
  const Study trapezoid =
      converge(plan_levels(falling_net({"integrator.method=newmark"}), 4, Vary::step));
  for (const char* name : {"center.z", "kinetic_energy_final", "stretching_energy_final"}) {
    const Judgement& first = trend(euler.series[0], name).judgement;
    const Judgement& second = trend(trapezoid.series[0], name).judgement;
    ASSERT_TRUE(first.order && second.order) << name;
    EXPECT_NEAR(*first.order, 1.0, 0.06) << name;
    EXPECT_NEAR(*second.order, 2.0, 0.12) << name;
    // Both lead to the same place, each to within what it still lacks.
    EXPECT_NEAR(*first.limit, *second.limit, 2e-4 * std::abs(*second.limit)) << name;
    EXPECT_EQ(first.verdict, Verdict::holds);
  }
}

TEST(Converge, SaysWhatDoesNotHold) {
  const Mission coarse = falling_net({"integrator.step=0.01", "phase[0].until=time >= 0.2"});
  const Study study = converge(plan_levels(coarse, 3, Vary::step));
  const SeriesResult& steps = study.series[0];
  EXPECT_EQ(trend(steps, "peak_tension").judgement.verdict, Verdict::does_not_hold);
  EXPECT_GT(*trend(steps, "peak_tension").judgement.change, 0.04);
  EXPECT_EQ(trend(steps, "mouth_area_final").judgement.verdict, Verdict::holds);
  EXPECT_THAT(steps.summary(0.02), HasSubstr("quantities hold at 2 %"));
}

TEST(Converge, ToleranceDecidesWhatHolds) {
  ConvergeOptions strict;
  strict.tolerance = 1e-6;
  const Study study = converge(plan_levels(falling_net(), 2, Vary::step), strict);
  EXPECT_EQ(trend(study.series[0], "peak_tension").judgement.verdict, Verdict::does_not_hold);
}

// Without halvings and with few iterations fine meshes cannot take their first steps: the study in
// which just so many levels finish.
Study finishing(std::size_t levels) {
  for (int iterations = 2; iterations < 30; ++iterations) {
    const Mission mission = falling_net(
        {"integrator.step=0.01", "phase[0].until=time >= 0.2", "integrator.max_halvings=0",
         "integrator.max_iterations=" + std::to_string(iterations)});
    Study study = converge(plan_levels(mission, 4, Vary::mesh));
    std::size_t finished = 0;
    while (finished < 4 && study.levels[finished].usable()) ++finished;
    if (finished == levels) return study;
  }
  throw Error("no limit of iterations lets so many levels finish");
}

TEST(Converge, TellsALevelThatFailsAndComparesTheOthers) {
  const Study study = finishing(3);
  EXPECT_EQ(study.levels[3].outcome, Outcome::failed);
  EXPECT_THAT(study.levels[3].reason, HasSubstr("does not converge"));
  const Trend& tension = trend(study.series[0], "peak_tension");
  EXPECT_TRUE(std::isnan(tension.values[3]));
  EXPECT_TRUE(tension.judgement.order);  // of the three levels before it
  EXPECT_EQ(tension.judgement.verdict, Verdict::holds);
}

TEST(Converge, KnowsNothingWhereAllFinerLevelsFail) {
  const Study study = finishing(1);
  EXPECT_EQ(study.levels[1].outcome, Outcome::failed);
  EXPECT_EQ(study.series[0].count(Verdict::unknown), study.series[0].trends.size());
  EXPECT_THAT(study.series[0].summary(0.02), HasSubstr("nobody knows"));
}

TEST(Converge, BeginsNoFurtherLevelOnceStopped) {
  std::atomic<bool> stop{false};
  ConvergeOptions options;
  options.stop = &stop;
  int begun = 0;
  options.watch = [&](std::size_t level) -> Observer* {
    ++begun;
    stop = level == 1;
    return nullptr;
  };
  const Study study = converge(plan_levels(falling_net(), 4, Vary::step), options);
  EXPECT_TRUE(study.interrupted);
  EXPECT_EQ(begun, 2);
  EXPECT_EQ(study.levels[0].outcome, Outcome::finished);
  EXPECT_EQ(study.levels[3].reason, "not begun");
}

// What a mission says wrongly is the user's to mend, not a level's failure.
TEST(Converge, ThrowsWhereTheMissionItselfDoesNotFit) {
  Mission mission = falling_net();
  mission.phases[0].fix = {"corner9"};
  const Plan plan = plan_levels(mission, 2, Vary::step);
  EXPECT_THROW(converge(plan), InputError);
}

TEST(Converge, GivesTheSameEveryTime) {
  const Plan plan = plan_levels(falling_net(), 2, Vary::both);
  const Study one = converge(plan), other = converge(plan);
  for (std::size_t s = 0; s < one.series.size(); ++s)
    for (std::size_t k = 0; k < one.series[s].trends.size(); ++k)
      EXPECT_EQ(one.series[s].trends[k].values, other.series[s].trends[k].values);
}

}  // namespace
}  // namespace retiarius

// Results made by hand: one case that passes, one that misses a bound, one that broke off, one
// that is only drawn.
#pragma once

#include "verification/framework/ladder.hpp"

namespace retiarius::verification::testing {

inline Chart made_chart() {
  Chart chart;
  chart.title = "Deflection <a|b>";
  chart.x_label = "load / N";
  chart.y_label = "deflection / m";
  chart.caption = "EI = 1 N m2.";
  chart.source = "Euler 1744";
  chart.curves = {{"ours", {0, 1, 2}, {0, 1, 4}, CurveStyle::line},
                  {"reference", {0, 1, 2}, {0, 1, 4}, CurveStyle::points}};
  return chart;
}

inline Comparison made_comparison() {
  return {"tip deflection",    "m",  0.123456789,  0.123457,
          ErrorKind::absolute, 1e-6, "Euler 1744", "one unit of the last printed digit"};
}

inline const std::vector<Case>& made_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> made(4);
    made[0].name = "elastica";
    made[0].title = "Tip-loaded elastica";
    made[0].group = Group::rods;
    made[0].figure = "Fig. 14";
    made[0].about = "A rod & its tip.";
    made[1].name = "wrong";
    made[1].title = "A case that misses";
    made[1].group = Group::rods;
    made[2].name = "broken";
    made[2].title = "A case that breaks off";
    made[2].group = Group::cables;
    made[3].name = "drawn";
    made[3].title = "A case without published values";
    made[3].group = Group::cables;
    return made;
  }();
  return cases;
}

inline std::vector<Rung> made_rungs() {
  std::vector<Rung> rungs(4);
  for (std::size_t k = 0; k < 4; ++k) rungs[k].of = &made_cases()[k];
  rungs[0].result.comparisons = {made_comparison()};
  rungs[0].result.charts = {made_chart()};
  rungs[0].result.notes = {"Linear theory stops at a load of one."};
  rungs[0].result.wall_time = 1.25;
  Comparison missed = made_comparison();
  missed.ours = 0.25;
  rungs[1].result.comparisons = {made_comparison(), missed};
  rungs[2].result.failure = "the step at 0.3 s did not converge";
  rungs[3].result.charts = {made_chart()};
  return rungs;
}

// Only what passes.
inline std::vector<Rung> good_rungs() {
  const std::vector<Rung> all = made_rungs();
  return {all[0], all[3]};
}

}  // namespace retiarius::verification::testing

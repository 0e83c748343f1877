#include "program/converge_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "program/text_table.hpp"

namespace retiarius::program {

namespace {

std::string value_text(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "-";
  if (unit == "yes/no") return value != 0.0 ? "yes" : "no";
  return fmt::format("{:.5g}", value);
}

std::string series_text(const Study& study, std::size_t number) {
  const Series& series = study.plan.series[number];
  const SeriesResult& result = study.series[number];
  TextTable table;
  std::vector<std::string> heading = {"quantity", "unit"};
  for (std::size_t level : series.levels) heading.push_back(study.plan.levels[level].name);
  for (const char* name : {"change", "order", "verdict"}) heading.emplace_back(name);
  table.add(heading);
  for (const Trend& trend : result.trends) {
    const Judgement& j = trend.judgement;
    // Phases and probes that hold are in the page and in the JSON.
    const bool of_part = trend.name.find('.') != std::string::npos;
    if (of_part && j.verdict == Verdict::holds) continue;
    std::vector<std::string> row = {trend.name, trend.unit == "yes/no" ? "" : trend.unit};
    for (double v : trend.values) row.push_back(value_text(v, trend.unit));
    row.push_back(j.change ? fmt::format("{:.2g} %", 100.0 * *j.change) : "-");
    row.push_back(j.order ? fmt::format("{:.2f}", *j.order) : "-");
    row.emplace_back(to_string(j.verdict));
    table.add(row);
  }
  return fmt::format("\nfiner {}:\n{}{}\n", series.name, table.text(),
                     result.summary(study.tolerance));
}

}  // namespace

std::string plan_text(const Plan& plan) {
  TextTable table;
  table.add({"run", "step", "segments", "nodes", "steps", "cost"});
  for (const Level& level : plan.levels)
    table.add({level.name, fmt::format("{:.6g} s", level.mission.phases.front().integrator.step),
               fmt::format("{}", level.mission.net.segments), fmt::format("{:.0f}", level.nodes),
               level.steps > 0.0 ? fmt::format("{:.0f}", level.steps) : "unknown",
               fmt::format("{:.3g}", level.cost)});
  std::string text =
      fmt::format("{} runs; together they cost about {:.3g} times the mission as given\n{}",
                  plan.levels.size(), plan.cost(), table.text());
  for (const std::string& note : plan.notes) text += fmt::format("note: {}\n", note);
  return text;
}

std::string level_text(const Level& level, const LevelResult& result) {
  return fmt::format("{}: {} in {}{}{}\n", level.name, to_string(result.outcome),
                     duration(result.wall_time), result.reason.empty() ? "" : ": ", result.reason);
}

std::string study_text(const Study& study) {
  std::string text;
  for (std::size_t k = 0; k < study.series.size(); ++k) text += series_text(study, k);
  return text;
}

}  // namespace retiarius::program

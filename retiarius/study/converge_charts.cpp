#include "retiarius/study/converge_charts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace retiarius {

namespace {

constexpr std::size_t kMostCurves = 6;

// A column of the history for every level of the series.
Chart history_chart(const Study& study, std::size_t number, const std::string& title,
                    const std::string& y_label, double HistoryRow::*value) {
  const Series& series = study.plan.series[number];
  Chart chart;
  chart.title = title;
  chart.x_label = "time / s";
  chart.y_label = y_label;
  for (std::size_t level : series.levels) {
    if (study.levels[level].rows.empty()) continue;
    const Level& l = study.plan.levels[level];
    Curve curve;
    curve.name = series.vary == Vary::step
                     ? fmt::format("h = {:.4g} s", l.mission.phases.front().integrator.step)
                     : fmt::format("{} segments a piece", l.mission.net.segments);
    if (!study.levels[level].usable())
      curve.name += fmt::format(" ({})", to_string(study.levels[level].outcome));
    for (const HistoryRow& row : study.levels[level].rows) {
      curve.x.push_back(row.time);
      curve.y.push_back(row.*value);
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.caption = series.vary == Vary::step ? "The mesh as given, the step halved."
                                            : "The step as given, the segments doubled.";
  return chart;
}

bool is_flat(const Chart& chart) {
  return std::all_of(chart.curves.begin(), chart.curves.end(), [](const Curve& curve) {
    return curve.x.size() < 2 ||
           std::all_of(curve.y.begin(), curve.y.end(), [](double y) { return y == 0.0; });
  });
}

// Changes of the measures from their values on the finest level that has them, in percent.
Chart measure_chart(const Study& study, std::size_t number) {
  const Series& series = study.plan.series[number];
  Chart chart;
  chart.title = "Measures against the " + series.name;
  chart.x_label = series.vary == Vary::step ? "step h / s" : "segment length / m";
  chart.y_label = "distance from the finest level / %";
  chart.log_x = true;
  std::vector<const Trend*> trends;
  for (const Trend& trend : study.series[number].trends) {
    const bool of_phase = trend.name.find('.') != std::string::npos;
    const auto& change = trend.judgement.change;
    if (!of_phase && change && *change > 1e-9 && trend.unit != "yes/no") trends.push_back(&trend);
  }
  // Those that change most are those to look at.
  std::stable_sort(trends.begin(), trends.end(), [](const Trend* a, const Trend* b) {
    return *a->judgement.change > *b->judgement.change;
  });
  if (trends.size() > kMostCurves) trends.resize(kMostCurves);
  for (const Trend* trend : trends) {
    const auto finest = std::find_if(trend->values.rbegin(), trend->values.rend(),
                                     [](double v) { return std::isfinite(v); });
    const double scale = std::max(std::abs(*finest), trend->size);
    Curve curve{trend->name, series.sizes, {}, CurveStyle::line};
    for (double v : trend->values) curve.y.push_back(100.0 * (v - *finest) / scale);
    chart.curves.push_back(std::move(curve));
  }
  chart.caption = fmt::format("The {} measures of the whole run that changed most.", trends.size());
  return chart;
}

}  // namespace

std::vector<Chart> converge_charts(const Study& study, std::size_t series) {
  using Row = HistoryRow;
  std::vector<Chart> charts = {
      history_chart(study, series, "Mouth area", "mouth area / m\u00b2", &Row::mouth_area),
      history_chart(study, series, "Peak tension", "tension / N", &Row::peak_tension),
      history_chart(study, series, "Kinetic energy", "energy / J", &Row::kinetic_energy),
      history_chart(study, series, "Stretching energy", "energy / J", &Row::stretching_energy),
      history_chart(study, series, "Bending energy", "energy / J", &Row::bending_energy)};
  std::erase_if(charts, is_flat);
  Chart measures = measure_chart(study, series);
  if (!measures.curves.empty()) charts.push_back(std::move(measures));
  return charts;
}

}  // namespace retiarius

#include "retiarius/study/converge_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "retiarius/base/build_info.hpp"

namespace retiarius {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json level_json(const Level& level, const LevelResult& result) {
  return {{"name", level.name},
          {"step", level.mission.phases.front().integrator.step},
          {"segments", level.mission.net.segments},
          {"nodes", level.nodes},
          {"cost", level.cost},
          {"outcome", to_string(result.outcome)},
          {"reason", result.reason},
          {"wall_time", result.wall_time}};
}

Json trend_json(const Trend& trend) {
  Json values = Json::array();
  for (double v : trend.values) values.push_back(number(v));
  return {{"name", trend.name},
          {"unit", trend.unit},
          {"values", std::move(values)},
          {"change", number(trend.judgement.change)},
          {"order", number(trend.judgement.order)},
          {"limit", number(trend.judgement.limit)},
          {"verdict", to_string(trend.judgement.verdict)}};
}

Json series_json(const Series& series, const SeriesResult& result) {
  Json quantities = Json::array();
  for (const Trend& trend : result.trends) quantities.push_back(trend_json(trend));
  return {{"varied", series.name},
          {"levels", series.levels},
          {"sizes", series.sizes},
          {"quantities", std::move(quantities)}};
}

}  // namespace

std::string converge_json(const Study& study) {
  const BuildInfo& build = build_info();
  Json levels = Json::array(), series = Json::array();
  for (std::size_t k = 0; k < study.levels.size(); ++k)
    levels.push_back(level_json(study.plan.levels[k], study.levels[k]));
  for (std::size_t k = 0; k < study.series.size(); ++k)
    series.push_back(series_json(study.plan.series[k], study.series[k]));
  const Json all = {{"format", 1},
                    {"title", study.plan.levels.front().mission.title},
                    {"version", build.version},
                    {"revision", build.revision},
                    {"tolerance", study.tolerance},
                    {"interrupted", study.interrupted},
                    {"notes", study.plan.notes},
                    {"levels", std::move(levels)},
                    {"series", std::move(series)}};
  return all.dump(1) + "\n";
}

}  // namespace retiarius

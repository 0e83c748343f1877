#include "verification/framework/results_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"

namespace retiarius::verification {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (double v : values) list.push_back(number(v));
  return list;
}

Json comparison_json(const Comparison& c) {
  return {{"quantity", c.quantity},
          {"unit", c.unit},
          {"ours", number(c.ours)},
          {"reference", number(c.reference)},
          {"error", number(c.error())},
          {"error_kind", c.kind == ErrorKind::relative ? "relative" : "absolute"},
          {"bound", number(c.bound)},
          {"passes", c.passes()},
          {"source", c.source},
          {"argument", c.argument}};
}

Json chart_json(const Chart& chart) {
  Json curves = Json::array();
  for (const Curve& c : chart.curves)
    curves.push_back({{"name", c.name}, {"x", numbers(c.x)}, {"y", numbers(c.y)}});
  return {{"title", chart.title},     {"x_label", chart.x_label}, {"y_label", chart.y_label},
          {"caption", chart.caption}, {"source", chart.source},   {"curves", std::move(curves)}};
}

Json rung_json(const Rung& rung) {
  Json comparisons = Json::array(), charts = Json::array();
  for (const Comparison& c : rung.result.comparisons) comparisons.push_back(comparison_json(c));
  for (const Chart& c : rung.result.charts) charts.push_back(chart_json(c));
  return {{"name", rung.of->name},
          {"title", rung.of->title},
          {"group", title(rung.of->group)},
          {"figure", rung.of->figure},
          {"passes", rung.result.passes()},
          {"failure", rung.result.failure},
          {"wall_time", rung.result.wall_time},
          {"comparisons", std::move(comparisons)},
          {"notes", rung.result.notes},
          {"charts", std::move(charts)}};
}

}  // namespace

std::string results_json(const std::vector<Rung>& rungs, bool quick) {
  const BuildInfo build = build_info();
  Json cases = Json::array();
  for (const Rung& rung : rungs) cases.push_back(rung_json(rung));
  const Json all = {{"format", 1},
                    {"version", build.version},
                    {"revision", build.revision},
                    {"kernels", kernel_name()},
                    {"quick", quick},
                    {"passes", passes(rungs)},
                    {"cases", std::move(cases)}};
  return all.dump(1) + "\n";
}

}  // namespace retiarius::verification

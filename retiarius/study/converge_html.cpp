#include "retiarius/study/converge_html.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/report/chart_page.hpp"
#include "retiarius/report/chart_svg.hpp"
#include "retiarius/report/svg_plot.hpp"
#include "retiarius/study/converge_charts.hpp"

namespace retiarius {

namespace {

std::string value_html(double value, const std::string& unit) {
  if (!std::isfinite(value)) return "\u2013";
  if (unit == "yes/no") return value != 0.0 ? "yes" : "no";
  std::string text = fmt::format("{:.6g}", value);
  if (text[0] == '-') text.replace(0, 1, "\u2212");
  if (unit.empty() || unit == "1") return text;
  return fmt::format("{} {}", text, escape_html(unit));
}

std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:.2g} %", 100.0 * *share) : "\u2013";
}

const char* tone(Verdict verdict) { return verdict == Verdict::holds ? "ok" : "miss"; }

std::string verdict_html(const Study& study) {
  bool all = true;
  std::string lines;
  for (std::size_t k = 0; k < study.series.size(); ++k) {
    const SeriesResult& s = study.series[k];
    const std::size_t holds = s.count(Verdict::holds);
    all = all && holds == s.trends.size() && holds > 0;
    lines += fmt::format("<p>Finer {}: {}.</p>", escape_html(study.plan.series[k].name),
                         s.summary(study.tolerance));
  }
  for (const std::string& note : study.plan.notes)
    lines += fmt::format("<p class=\"soft\">Note: {}.</p>", escape_html(note));
  return fmt::format("<section class=\"verdict {}\"><p class=\"big\">{}</p>{}</section>",
                     all ? "good" : "bad", all ? "All quantities hold" : "Not all quantities hold",
                     lines);
}

std::string levels_html(const Study& study) {
  std::string html =
      "<h2>Runs</h2><article><div class=\"table\"><table><thead><tr><th>run</th><th>step</th>"
      "<th>segments</th><th>nodes</th><th>cost</th><th>time</th><th>outcome</th></tr></thead>"
      "<tbody>";
  for (std::size_t k = 0; k < study.levels.size(); ++k) {
    const Level& level = study.plan.levels[k];
    const LevelResult& result = study.levels[k];
    html += fmt::format(
        "<tr{}><th scope=\"row\">{}</th><td data-l=\"step\">{:.6g} s</td>"
        "<td data-l=\"segments\">{}</td><td data-l=\"nodes\">{:.0f}</td>"
        "<td data-l=\"cost\">{:.3g}</td><td data-l=\"time\">{:.3g} s</td>"
        "<td data-l=\"outcome\">{}{}</td></tr>",
        result.usable() ? "" : " class=\"missed\"", escape_html(level.name),
        level.mission.phases.front().integrator.step, level.mission.net.segments, level.nodes,
        level.cost, result.wall_time, to_string(result.outcome),
        result.reason.empty() ? "" : ": " + escape_html(result.reason));
  }
  return html +
         "</tbody></table></div><p class=\"soft\">Cost: nodes times steps, that of the "
         "mission as given being 1.</p></article>";
}

std::string trend_html(const Trend& trend, const Study& study, const Series& series) {
  const Judgement& j = trend.judgement;
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", escape_html(trend.name));
  for (std::size_t k = 0; k < trend.values.size(); ++k)
    html += fmt::format("<td data-l=\"{}\">{}</td>",
                        escape_html(study.plan.levels[series.levels[k]].name),
                        value_html(trend.values[k], trend.unit));
  return html + fmt::format(
                    "<td data-l=\"change\">{}</td><td data-l=\"order\">{}</td>"
                    "<td data-l=\"verdict\"><span class=\"badge {}\">{}</span></td></tr>",
                    percent(j.change), j.order ? fmt::format("{:.2f}", *j.order) : "\u2013",
                    tone(j.verdict), to_string(j.verdict));
}

std::string series_html(const Study& study, std::size_t number) {
  const Series& series = study.plan.series[number];
  std::string html =
      fmt::format("<h2>Finer {}</h2><article><div class=\"charts\">", escape_html(series.name));
  std::size_t k = 0;
  for (const Chart& chart : converge_charts(study, number))
    html += fmt::format("<figure><h4>{}</h4>{}<figcaption>{}</figcaption></figure>",
                        escape_html(chart.title),
                        chart_svg(chart, ChartLook::page, fmt::format("s{}-{}", number, ++k)),
                        escape_html(chart.caption));
  html += "</div><div class=\"table\"><table><thead><tr><th>quantity</th>";
  for (std::size_t level : series.levels)
    html += fmt::format("<th>{}</th>", escape_html(study.plan.levels[level].name));
  html += "<th>last change</th><th>order</th><th>verdict</th></tr></thead><tbody>";
  for (const Trend& trend : study.series[number].trends) html += trend_html(trend, study, series);
  return html + "</tbody></table></div></article>";
}

}  // namespace

std::string converge_html(const Study& study) {
  const std::string& given = study.plan.levels.front().mission.title;
  const std::string title = escape_html(given.empty() ? "Mission" : given);
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
      "<title>Convergence: {0} \u00b7 Retiarius</title><style>{1}</style></head>\n<body><main>"
      "<p class=\"brand\">Retiarius convergence study</p><h1>{0}</h1>"
      "<p class=\"lead\">A quantity holds when the last refinement changes it by no more than the "
      "tolerance. It is chaotic when finer levels change it no less than coarser ones did: then no "
      "single run tells it, only many do.</p>",
      title, kChartPageStyle);
  html += verdict_html(study) + levels_html(study);
  for (std::size_t k = 0; k < study.series.size(); ++k) html += series_html(study, k);
  return html + "</main></body></html>\n";
}

}  // namespace retiarius

#include "retiarius/report/report_html.hpp"

#include <fmt/format.h>

#include "retiarius/record/summary_json.hpp"
#include "retiarius/report/report_heading.hpp"
#include "retiarius/report/report_plots.hpp"
#include "retiarius/report/scene_svg.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

std::string phase_name(const ReportData& data, Index phase) {
  const auto k = static_cast<std::size_t>(phase);
  return k < data.run.phases.size() ? data.run.phases[k].name : fmt::format("phase {}", phase);
}

std::string story_html(const ReportData& data) {
  if (data.pictures.empty()) return "";
  std::string html = "<h2>Storyboard</h2><div class=\"story\">";
  int number = 0;
  for (const Picture& picture : data.pictures) {
    const std::string name = phase_name(data, picture.phase);
    const std::string alternative =
        fmt::format("Net{} at {:.4g} s, phase {}, seen from the side and above.",
                    data.scene.bodies.empty()       ? ""
                    : data.scene.bodies.size() == 1 ? " and body"
                                                    : " and bodies",
                    picture.time, name);
    html += fmt::format(
        "<figure><figcaption><span><b>{}</b>{}</span><span>t = {:.4g} s</span></figcaption>{}"
        "</figure>",
        ++number, escape_html(name), picture.time, scene_svg(data.scene, picture, alternative));
  }
  return html + "</div>";
}

std::string plots_html(const ReportData& data) {
  std::string html = "<h2>History</h2>";
  if (data.rows.empty()) return html + "<p class=\"note\">No row was recorded.</p>";
  if (data.run.phases.size() > 1)
    html += "<p class=\"note\">Dotted vertical lines: a phase ends and the next begins.</p>";
  html += "<div class=\"plots\">";
  for (const Plot& plot : report_plots(data))
    html += fmt::format("<figure><figcaption>{}</figcaption>{}{}</figure>", escape_html(plot.title),
                        legend_html(plot), plot_svg(plot));
  return html + "</div>";
}

std::string phases_html(const ReportData& data) {
  if (data.run.phases.empty()) return "";
  std::string html =
      "<h2>Phases</h2><div class=\"table\"><table><thead><tr><th>Phase</th><th>Kind</th>"
      "<th class=\"num\">Start / s</th><th class=\"num\">End / s</th><th>Ended by</th>"
      "</tr></thead><tbody>";
  for (const PhaseReport& phase : data.run.phases)
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"num\">{:.6g}</td><td class=\"num\">"
        "{:.6g}</td><td><code>{}</code></td></tr>",
        escape_html(phase.name), phase_kind_name(phase.kind), phase.start, phase.end,
        escape_html(phase.trigger));
  html += "</tbody></table></div>";
  for (const PhaseReport& phase : data.run.phases) {
    if (phase.measures.empty()) continue;
    html += fmt::format("<details><summary>Measures of phase {}</summary><table><tbody>",
                        escape_html(phase.name));
    for (const Measure& measure : phase.measures)
      html += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td></tr>",
                          spaced(escape_html(measure.name)), measure_html(measure));
    html += "</tbody></table></details>";
  }
  return html;
}

std::string rows_html(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string html = "<div class=\"table\"><table><tbody>";
  for (const auto& [name, value] : rows)
    html += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"num\">{}</td></tr>",
                        escape_html(name), value);
  return html + "</tbody></table></div>";
}

std::string measures_html(const Measures& measures) {
  if (measures.empty()) return "";
  std::vector<std::pair<std::string, std::string>> left, right;
  for (std::size_t k = 0; k < measures.size(); ++k)
    (2 * k < measures.size() ? left : right)
        .emplace_back(spaced(measures[k].name), measure_html(measures[k]));
  std::string html = "<h2>Measures of the whole run</h2><div class=\"columns\">" + rows_html(left);
  if (!right.empty()) html += rows_html(right);
  return html + "</div>";
}

std::string versions_html(const ReportData& data) {
  std::vector<std::pair<std::string, std::string>> program = {
      {"Retiarius", escape_html(data.build.version)},
      {"Compiler", escape_html(data.build.compiler)},
      {"Build type", escape_html(data.build.build_type)},
      {"Kernels", escape_html(data.build.kernels)},
      {"Seed", fmt::format("{}", data.seed)}};
  std::vector<std::pair<std::string, std::string>> parts;
  for (const auto& [name, value] : data.build.options)
    parts.emplace_back("Option " + name, escape_html(value));
  for (const auto& [name, value] : data.build.libraries)
    parts.emplace_back(name, escape_html(value));
  std::string html = "<h2>Versions</h2><div class=\"columns\">" + rows_html(program);
  if (!parts.empty()) html += rows_html(parts);
  return html + "</div>";
}

std::string mission_html(const ReportData& data) {
  std::string html = "<h2>Mission</h2>";
  if (!data.start_report.empty())
    html += fmt::format(
        "<details><summary>What was chosen at the start</summary><pre>{}</pre>"
        "</details>",
        escape_html(data.start_report));
  return html + fmt::format(
                    "<details><summary>The mission with every default filled in"
                    "</summary><pre>{}</pre></details>",
                    escape_html(data.resolved));
}

}  // namespace

std::string report_html(const ReportData& data, const std::string& note) {
  const std::string title = escape_html(data.title.empty() ? "Mission" : data.title);
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
      "<title>{0} \u00b7 Retiarius</title><style>{1}</style></head>\n<body><main>"
      "<p class=\"brand\">Retiarius report</p><h1>{0}</h1>",
      title, kReportStyle);
  html += outcome_html(data) + cards_html(data.run.measures) + "\n";
  if (!note.empty()) html += "<p class=\"note\">" + escape_html(note) + "</p>\n";
  html += story_html(data) + "\n" + plots_html(data) + "\n";
  html += phases_html(data) + "\n" + measures_html(data.run.measures) + "\n";
  html += mission_html(data) + "\n" + versions_html(data);
  return html + "\n</main></body></html>\n";
}

}  // namespace retiarius

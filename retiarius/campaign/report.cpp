#include "retiarius/campaign/report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/campaign/report_influence.hpp"
#include "retiarius/campaign/report_spread.hpp"
#include "retiarius/campaign/report_success.hpp"
#include "retiarius/campaign/report_tables.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/report/chart_page.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kMapInputs = 5, kAlong = 6, kResponses = 6, kResponseInputs = 2;
constexpr std::size_t kTornados = 6, kSobols = 4, kHistograms = 12;

constexpr const char* kOwnStyle = R"css(
.wide .charts{grid-template-columns:repeat(auto-fit,minmax(min(100%,300px),1fr))}
.facts{margin:.2em 0 1.4em;padding:0;list-style:none;color:var(--soft);font-size:.9rem}
.more td{border-top:0;padding-top:0;font-size:.88rem}
.command{display:block;margin-top:.2em;overflow-wrap:anywhere;font-size:.8rem}
@media print{.verdict,article{border-color:#bbb}article{border:0;padding:6px 0}
.charts{grid-template-columns:1fr 1fr!important}.wide .charts{grid-template-columns:1fr 1fr 1fr!important}
thead th{overflow-wrap:anywhere}table{font-size:.8rem}main{padding:0}h2{break-after:avoid}}
)css";

std::string figure_html(const CampaignFigure& figure) {
  std::string html = fmt::format("<figure><h4>{}</h4>{}", escape_html(figure.title), figure.svg);
  if (!figure.caption.empty()) html += "<figcaption>" + figure.caption + "</figcaption>";
  return html + "</figure>";
}

// A part of the page; empty where it has no figures.
std::string part_html(const char* title, const std::string& lead,
                      const std::vector<CampaignFigure>& figures, bool narrow = false) {
  if (figures.empty()) return "";
  std::string html = fmt::format("<h2>{}</h2><article{}>", title, narrow ? " class=\"wide\"" : "");
  if (!lead.empty()) html += "<p>" + lead + "</p>";
  html += "<div class=\"charts\">";
  for (const CampaignFigure& figure : figures) html += figure_html(figure);
  return html + "</div></article>";
}

std::string verdict_html(const ReportColumns& columns) {
  const CampaignTable& table = *columns.table;
  const SuccessCount count = count_success(columns);
  const bool by_hand = table.design == CampaignDesign::prescribed;
  std::string html = "<section class=\"verdict\">";
  if (count.answered == 0) {
    html += "<p class=\"big\">No run tells success</p>";
  } else {
    const Interval i = count.interval();
    html += fmt::format("<p class=\"big\">{} succeed</p>", percent_text(count.rate()));
    html += by_hand
                ? fmt::format(
                      "<p>{} of {} runs. Their inputs were chosen one by one, so this is a "
                      "share of these runs and no probability.</p>",
                      count.successes, count.answered)
                : fmt::format(
                      "<p>{} of {} runs; the probability lies between <b>{}</b> and "
                      "<b>{}</b> with 95 % confidence (Wilson).</p>",
                      count.successes, count.answered, percent_text(i.low), percent_text(i.high));
  }
  if (count.unanswered > 0 && count.answered > 0)
    html += fmt::format(
        "<p>{} run{} came to no answer and {} not counted; counted as failures they make it "
        "{}.</p>",
        count.unanswered, count.unanswered == 1 ? "" : "s", count.unanswered == 1 ? "is" : "are",
        percent_text(static_cast<double>(count.successes) /
                     static_cast<double>(count.answered + count.unanswered)));
  if (table.design == CampaignDesign::saltelli)
    html += fmt::format(
        "<p>Of {} runs, {} draw their inputs independently (rows of A and B) and are counted "
        "here; the others serve the Sobol indices.</p>",
        table.runs.size(), columns.runs.size());
  const auto done = static_cast<std::int64_t>(table.runs.size());
  if (table.planned > done)
    html +=
        fmt::format("<p class=\"soft\">{} of {} planned runs are done.</p>", done, table.planned);
  return html + "</section>";
}

std::string success_html(const ReportColumns& columns) {
  const SuccessCount count = count_success(columns);
  if (count.answered == 0) return "";
  std::vector<CampaignFigure> figures;
  const std::vector<std::size_t>& by = columns.ranked;
  std::string html;
  if (by.size() >= 2) {
    html += part_html("Where captures succeed",
                      fmt::format("The two inputs that success depends on most: {} and {}.",
                                  escape_html(columns.table->inputs[by[0]]),
                                  escape_html(columns.table->inputs[by[1]])),
                      {success_map(columns, by[0], by[1], "map"),
                       success_points(columns, by[0], by[1], "points")});
  }
  figures.push_back(convergence_figure(columns));
  for (std::size_t k = 0; k < std::min(kAlong, by.size()); ++k)
    figures.push_back(success_along(columns, by[k], fmt::format("along-{}", k)));
  html += part_html("Success rate",
                    "Against the number of runs, and in classes of each input; whiskers are 95 % "
                    "intervals.",
                    figures);
  figures.clear();
  const std::size_t shown = std::min(kMapInputs, by.size());
  for (std::size_t a = 0; a < shown; ++a)
    for (std::size_t b = a + 1; b < shown; ++b)
      if (a != 0 || b != 1)
        figures.push_back(success_map(columns, by[a], by[b], fmt::format("map-{}-{}", a, b), true));
  return html + part_html("Success over other pairs of inputs",
                          "Blue: most succeed; orange: most do not; pale: half, or few runs.",
                          figures, true);
}

std::string influence_html(const ReportColumns& columns) {
  std::vector<const CampaignResult*> results = {&columns.success};
  for (const CampaignResult& result : columns.results) results.push_back(&result);
  std::vector<CampaignFigure> tornados, sobols;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const bool some = !strongest_first(influences(columns, *results[k])).empty();
    if (some && tornados.size() < kTornados)
      tornados.push_back(tornado_figure(columns, *results[k], fmt::format("tornado-{}", k)));
    if (sobols.size() >= 2 * kSobols) continue;
    if (auto figure = sobol_figure(columns, *results[k], fmt::format("sobol-{}", k)))
      sobols.push_back(std::move(*figure));
    if (auto figure = sobol_convergence_figure(columns, *results[k], fmt::format("sobol-n-{}", k)))
      sobols.push_back(std::move(*figure));
  }
  return part_html("Which inputs matter: share of the variance",
                   "Sobol indices: how much of a result's variance an input causes. Estimators of "
                   "Saltelli (first order) and Jansen (total).",
                   sobols) +
         part_html("Which inputs matter: rank correlation",
                   "Spearman's correlation with 95 % intervals; pale bars cannot be told from "
                   "none. Where a result is best or worst in the middle of an input, the "
                   "correlation is with the distance from the input's median.",
                   tornados);
}

std::string responses_html(const ReportColumns& columns) {
  std::vector<CampaignFigure> figures;
  for (std::size_t k = 0; k < std::min(kResponses, columns.results.size()); ++k) {
    const CampaignResult& result = columns.results[k];
    const std::vector<std::size_t> order = strongest_first(influences(columns, result));
    for (std::size_t j = 0; j < std::min(kResponseInputs, order.size()); ++j)
      figures.push_back(response_figure(columns, result, columns.ranked[order[j]],
                                        fmt::format("response-{}-{}", k, j)));
  }
  return part_html("How results answer to inputs",
                   "Each result over the inputs that it goes with most: runs (circles succeeded, "
                   "crosses did not) and means in classes of the input with 95 % intervals.",
                   figures);
}

std::string spreads_html(const ReportColumns& columns) {
  std::vector<CampaignFigure> inputs, results;
  for (std::size_t k = 0; k < std::min(kHistograms, columns.ranked.size()); ++k) {
    const std::size_t i = columns.ranked[k];
    inputs.push_back(histogram_figure(columns, columns.table->inputs[i], columns.inputs[i],
                                      fmt::format("input-{}", k)));
  }
  for (std::size_t k = 0; k < std::min(kHistograms, columns.results.size()); ++k)
    results.push_back(histogram_figure(columns, columns.results[k].name, columns.results[k].values,
                                       fmt::format("result-{}", k)));
  return part_html("Distributions of results", "", results, true) +
         part_html("Distributions of inputs", "", inputs, true);
}

std::string heading_html(const CampaignTable& table) {
  const std::string title = escape_html(table.title.empty() ? "Campaign" : table.title);
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
      "<title>{0} \u00b7 Retiarius</title><style>{1}{2}</style></head>\n<body><main>"
      "<p class=\"brand\">Retiarius campaign</p><h1>{0}</h1>",
      title, kChartPageStyle, kOwnStyle);
  if (table.facts.empty()) return html;
  html += "<ul class=\"facts\">";
  for (const std::string& fact : table.facts) html += "<li>" + escape_html(fact) + "</li>";
  return html + "</ul>";
}

}  // namespace

std::string campaign_html(const CampaignTable& table) {
  const ReportColumns columns = report_columns(table);
  std::string html = heading_html(table) + verdict_html(columns) + success_html(columns) +
                     influence_html(columns) + responses_html(columns) + spreads_html(columns);
  if (!table.runs.empty())
    html += "<h2>How runs ended</h2><article>" + endings_html(columns) +
            "</article><h2>Worst cases</h2><article>" + worst_html(columns) + "</article>";
  return html + "</main></body></html>\n";
}

void write_campaign_report(const CampaignTable& table, const std::filesystem::path& file) {
  write_atomically(file, campaign_html(table));
}

}  // namespace retiarius

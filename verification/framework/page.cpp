#include "verification/framework/page.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/report/chart_page.hpp"
#include "retiarius/report/chart_svg.hpp"
#include "retiarius/report/svg_plot.hpp"
#include "verification/framework/comparison_text.hpp"

namespace retiarius::verification {

namespace {

constexpr std::size_t kLongTable = 10;  // rows, beyond which a table without a miss is folded

std::string badge(const CaseResult& result) {
  const std::string word = verdict_word(result);
  return fmt::format("<span class=\"badge {}\">{}</span>", result.passes() ? word : "miss", word);
}

std::string verdict_html(const std::vector<Rung>& rungs, const PageOptions& options) {
  const Tally t = tally(rungs);
  const bool good = passes(rungs);
  std::string html = fmt::format(
      "<section class=\"verdict {}\"><p class=\"big\">{}</p><p>{} of {} cases passed, {} of {} "
      "comparisons are within their bounds.</p>",
      good ? "good" : "bad", good ? "All within bounds" : "Not all within bounds", t.passed,
      t.cases, t.within, t.comparisons);
  if (!good) {
    html += "<ul>";
    for (const Rung& rung : rungs) {
      if (rung.result.passes()) continue;
      html += fmt::format("<li><a href=\"#{0}\">{0}</a>: {1}</li>", escape_html(rung.of->name),
                          rung.result.failure.empty()
                              ? "a bound is missed"
                              : "broke off: " + escape_html(rung.result.failure));
    }
    html += "</ul>";
  }
  const BuildInfo& build = build_info();
  return html + fmt::format(
                    "<p class=\"soft\">Retiarius {} ({}), {} kernels, {} form, {:.0f} s.</p>"
                    "</section>",
                    escape_html(build.version), escape_html(build.revision),
                    escape_html(kernel_name()), options.quick ? "quick" : "full",
                    options.wall_time);
}

std::string contents_html(const std::vector<Rung>& rungs, bool others) {
  std::string html = "<nav><h2>Contents</h2>";
  const Case* before = nullptr;
  for (const Rung& rung : rungs) {
    if (!before || before->group != rung.of->group)
      html += fmt::format("{}<h3>{}</h3><ul>", before ? "</ul>" : "", title(rung.of->group));
    before = rung.of;
    html += fmt::format("<li>{}<a href=\"#{}\">{}</a>{}</li>", badge(rung.result),
                        escape_html(rung.of->name), escape_html(rung.of->title),
                        rung.of->figure.empty()
                            ? ""
                            : " <span class=\"soft\">" + escape_html(rung.of->figure) + "</span>");
  }
  if (before) html += "</ul>";
  if (others)
    html += "<ul><li><a href=\"#independent-programs\">Independent programs</a></li></ul>";
  return html + "</nav>";
}

std::string chart_html(const Chart& chart, const std::string& id) {
  std::string html = fmt::format("<figure><h4>{}</h4>{}<figcaption>{}", escape_html(chart.title),
                                 chart_svg(chart, ChartLook::page, id), escape_html(chart.caption));
  if (!chart.source.empty())
    html += fmt::format(" <span class=\"soft\">Source: {}.</span>", escape_html(chart.source));
  return html + "</figcaption></figure>";
}

// The distinct values of a member, in the order in which they first appear.
std::vector<std::string> distinct(const std::vector<Comparison>& comparisons,
                                  std::string Comparison::*member) {
  std::vector<std::string> values;
  for (const Comparison& c : comparisons)
    if (std::find(values.begin(), values.end(), c.*member) == values.end())
      values.push_back(c.*member);
  return values;
}

std::size_t place_of(const std::vector<std::string>& values, const std::string& value) {
  return static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

std::string row_html(const Comparison& c, const std::string& name, std::size_t argument,
                     bool with_source) {
  const std::string unit = escape_html(unit_text(c.unit));
  std::string html = fmt::format(
      "<tr{}><th scope=\"row\">{}</th><td data-l=\"ours\">{}{}</td><td data-l=\"reference\">{}{}"
      "</td><td data-l=\"error\">{}</td><td data-l=\"bound\">\u2264 {}<a class=\"why\" "
      "href=\"#{}-why-{}\" title=\"{}\">[{}]</a></td><td data-l=\"verdict\">{}</td>",
      c.passes() ? "" : " class=\"missed\"", escape_html(c.quantity), ours_text(c), unit,
      reference_text(c), unit, escape_html(error_text(c)), escape_html(bound_text(c)),
      escape_html(name), argument + 1, escape_html(c.argument), argument + 1,
      c.passes() ? "ok" : "<b>MISS</b>");
  if (with_source) html += fmt::format("<td data-l=\"source\">{}</td>", escape_html(c.source));
  return html + "</tr>";
}

// Error over bound of the comparison that comes nearest to its bound.
double largest_share(const std::vector<Comparison>& comparisons) {
  double share = 0.0;
  for (const Comparison& c : comparisons)
    if (c.bound > 0.0) share = std::max(share, c.error() / c.bound);
  return share;
}

std::string comparisons_html(const CaseResult& result, const std::string& name) {
  const std::vector<Comparison>& all = result.comparisons;
  if (all.empty()) return "";
  const std::vector<std::string> arguments = distinct(all, &Comparison::argument);
  const std::vector<std::string> sources = distinct(all, &Comparison::source);
  const bool good = std::all_of(all.begin(), all.end(), [](const auto& c) { return c.passes(); });
  const std::string verdict =
      good ? fmt::format("all within bounds; the largest error is {:.0f} % of its bound",
                         100.0 * largest_share(all))
           : "<b>not all within bounds</b>";
  std::string html = fmt::format("<details{}><summary>{} comparison{}, {}</summary>",
                                 good && all.size() > kLongTable ? "" : " open", all.size(),
                                 all.size() == 1 ? "" : "s", verdict);
  if (sources.size() == 1)
    html += fmt::format("<p class=\"source\">Reference: {}.</p>", escape_html(sources[0]));
  html +=
      "<div class=\"table\"><table><thead><tr><th>quantity</th><th>ours</th><th>reference</th>"
      "<th>error</th><th>bound</th><th>verdict</th>";
  html += sources.size() > 1 ? "<th>source</th></tr></thead><tbody>" : "</tr></thead><tbody>";
  for (const Comparison& c : all)
    html += row_html(c, name, place_of(arguments, c.argument), sources.size() > 1);
  html +=
      "</tbody></table></div><p class=\"source\">Why the bounds are what they are:</p>"
      "<ol class=\"whys\">";
  for (std::size_t k = 0; k < arguments.size(); ++k)
    html += fmt::format("<li id=\"{}-why-{}\">{}</li>", escape_html(name), k + 1,
                        escape_html(arguments[k]));
  return html + "</ol></details>";
}

std::string case_html(const Rung& rung) {
  const Case& c = *rung.of;
  const CaseResult& r = rung.result;
  const std::string name = escape_html(c.name);
  std::string html = fmt::format(
      "<article id=\"{}\" class=\"{}\"><h3>{}</h3><p class=\"tags\">{}<code>{}</code>{}"
      "<span class=\"soft\">{:.1f} s</span></p>",
      name, r.passes() ? "" : "bad", escape_html(c.title), badge(r), name,
      c.figure.empty() ? "" : "<span class=\"fig\">" + escape_html(c.figure) + "</span>",
      r.wall_time);
  if (!r.failure.empty())
    html += fmt::format("<p class=\"failure\"><b>Broke off:</b> {}</p>", escape_html(r.failure));
  html += fmt::format("<p>{}</p>", escape_html(c.about));
  if (r.comparisons.empty() && r.failure.empty())
    html += "<p class=\"soft\">No published values: drawn, with our own convergence.</p>";
  html += "<div class=\"charts\">";
  for (std::size_t k = 0; k < r.charts.size(); ++k)
    html += chart_html(r.charts[k], fmt::format("{}-{}", c.name, k + 1));
  html += "</div>" + comparisons_html(r, c.name);
  for (const std::string& note : r.notes)
    html += fmt::format("<p class=\"note\">{}</p>", escape_html(note));
  return html + "</article>\n";
}

std::string recorded_html(const Recorded& recorded) {
  if (recorded.comparisons.empty()) return "";
  std::string html = "<h2 id=\"independent-programs\">Independent programs</h2><article>";
  for (const std::string& text : recorded.about)
    html += fmt::format("<p>{}</p>", escape_html(text));
  html +=
      "<div class=\"table\"><table><thead><tr><th>scene, quantity</th><th>ours</th>"
      "<th>other</th><th>difference</th><th>bound</th></tr></thead><tbody>";
  for (const RecordedComparison& c : recorded.comparisons)
    html += fmt::format(
        "<tr><th scope=\"row\">{}: {}</th><td data-l=\"ours\">{}</td><td data-l=\"other\">{}"
        "</td><td data-l=\"difference\">{}</td><td data-l=\"bound\">\u2264 {}</td></tr>",
        escape_html(c.scene), escape_html(c.quantity), recorded_text(c.ours, 7, c.unit),
        recorded_text(c.theirs, 7, c.unit), recorded_text(c.difference, 2, c.unit),
        recorded_text(c.bound, 2, c.unit));
  html += "</tbody></table></div>";
  for (const RecordedScene& s : recorded.scenes)
    html += fmt::format(
        "<p class=\"soft\">{}: computed in {} s by Retiarius, in {} s by the other."
        "</p>",
        escape_html(s.name), printed(s.our_time, 2), printed(s.their_time, 2));
  return html + "</article>";
}

}  // namespace

std::string verification_page(const std::vector<Rung>& rungs, const PageOptions& options) {
  const bool others = !options.recorded.comparisons.empty();
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
      "<title>Verification \u00b7 Retiarius</title><style>{}</style></head>\n<body><main>"
      "<p class=\"brand\">Retiarius</p><h1>Verification</h1>"
      "<p class=\"lead\">Is it right? Every case computes something whose answer is known exactly, "
      "published, or computed independently, and draws ours over it.</p>",
      kChartPageStyle);
  html += verdict_html(rungs, options) + "\n" + contents_html(rungs, others) + "\n";
  const Case* before = nullptr;
  for (const Rung& rung : rungs) {
    if (!before || before->group != rung.of->group)
      html += fmt::format("<h2>{}</h2>\n", title(rung.of->group));
    before = rung.of;
    html += case_html(rung);
  }
  return html + recorded_html(options.recorded) + "</main></body></html>\n";
}

}  // namespace retiarius::verification

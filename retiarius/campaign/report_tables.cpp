#include "retiarius/campaign/report_tables.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

constexpr std::size_t kMostRuns = 25, kMostReasons = 12, kMostInputs = 3, kMostMeasures = 2;

struct Ending {
  std::int64_t runs = 0, successes = 0;
};

std::string share_of(std::int64_t part, std::size_t whole) {
  return percent_text(static_cast<double>(part) /
                      static_cast<double>(std::max<std::size_t>(1, whole)));
}

// A number by which worse runs come first.
double badness(const CampaignRow& row, std::size_t quality) {
  if (!row.success) return 1e300;
  if (quality >= row.measures.size() || !std::isfinite(row.measures[quality])) return 0.0;
  return row.measures[quality];
}

std::size_t quality_column(const CampaignTable& table) {
  for (const char* name : {"capture_quality_final", "capture_quality_settled"}) {
    const auto found = std::find(table.measures.begin(), table.measures.end(), name);
    if (found != table.measures.end())
      return static_cast<std::size_t>(found - table.measures.begin());
  }
  return table.measures.size();
}

std::size_t shown_inputs(const ReportColumns& columns) {
  return std::min(kMostInputs, columns.ranked.size());
}
std::size_t shown_measures(const ReportColumns& columns) {
  return std::min(kMostMeasures, columns.results.size());
}

std::string run_html(const ReportColumns& columns, const CampaignRow& row) {
  std::string html =
      fmt::format("<tr{}><th scope=\"row\">{}</th><td data-l=\"outcome\">{}</td>",
                  row.success ? "" : " class=\"missed\"", row.id, escape_html(row.outcome));
  for (std::size_t k = 0; k < shown_inputs(columns); ++k)
    html += fmt::format("<td data-l=\"{}\">{}</td>",
                        escape_html(columns.table->inputs[columns.ranked[k]]),
                        short_number(row.inputs[columns.ranked[k]]));
  for (std::size_t k = 0; k < shown_measures(columns); ++k)
    html += fmt::format("<td data-l=\"{}\">{}</td>", escape_html(columns.results[k].name),
                        short_number(row.measures[columns.results[k].measure]));
  html += "<td data-l=\"replay\">";
  if (!row.replay.empty())
    html += fmt::format("<a href=\"{}\">replay</a>", escape_html(row.replay));
  html += "</td></tr>";
  if (row.reason.empty() && row.command.empty()) return html;
  // A line of its own across the table, so that it fits on paper.
  html += fmt::format("<tr class=\"more{}\"><td colspan=\"{}\">{}", row.success ? "" : " missed",
                      3 + shown_inputs(columns) + shown_measures(columns), escape_html(row.reason));
  if (!row.command.empty())
    html += fmt::format("<code class=\"command\">{}</code>", escape_html(row.command));
  return html + "</td></tr>";
}

std::string run_heading(const ReportColumns& columns) {
  std::string html = "<thead><tr><th>run</th><th>outcome</th>";
  for (std::size_t k = 0; k < shown_inputs(columns); ++k)
    html += fmt::format("<th>{}</th>", escape_html(columns.table->inputs[columns.ranked[k]]));
  for (std::size_t k = 0; k < shown_measures(columns); ++k)
    html += fmt::format("<th>{}</th>", escape_html(columns.results[k].name));
  return html + "<th></th></tr></thead>";
}

std::string reasons_html(const CampaignTable& table) {
  struct Group {
    std::int64_t runs = 0, first = 0;
    std::string example;
  };
  std::map<std::string, Group> groups;
  for (const CampaignRow& row : table.runs) {
    if (row.reason.empty()) continue;
    Group& group = groups[row.outcome + ": " + without_numbers(row.reason)];
    if (group.runs++ == 0) {
      group.first = row.id;
      group.example = row.reason;
    }
  }
  if (groups.empty()) return "";
  std::vector<std::pair<std::string, Group>> sorted(groups.begin(), groups.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second.runs > b.second.runs; });
  std::string html =
      "<div class=\"table\"><table><thead><tr><th>reason</th><th>runs</th><th>first of them</th>"
      "<th>its words</th></tr></thead><tbody>";
  for (std::size_t k = 0; k < std::min(kMostReasons, sorted.size()); ++k)
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td data-l=\"runs\">{}</td><td data-l=\"first\">{}</td>"
        "<td data-l=\"words\">{}</td></tr>",
        escape_html(sorted[k].first), sorted[k].second.runs, sorted[k].second.first,
        escape_html(sorted[k].second.example));
  html += "</tbody></table></div>";
  if (sorted.size() > kMostReasons)
    html += fmt::format("<p class=\"soft\">{} rarer reasons are not listed.</p>",
                        sorted.size() - kMostReasons);
  return html;
}

}  // namespace

std::string without_numbers(const std::string& reason) {
  std::string text;
  for (std::size_t k = 0; k < reason.size(); ++k) {
    const char c = reason[k];
    const auto digit = [&](std::size_t at) {
      return at < reason.size() && std::isdigit(static_cast<unsigned char>(reason[at])) != 0;
    };
    const bool of_number =
        digit(k) || ((c == '.' || c == '-' || c == '+') && digit(k + 1) && text.ends_with('#')) ||
        (c == 'e' && text.ends_with('#') &&
         (digit(k + 1) || ((reason[std::min(k + 1, reason.size() - 1)] == '-' ||
                            reason[std::min(k + 1, reason.size() - 1)] == '+') &&
                           digit(k + 2))));
    if (!of_number)
      text += c;
    else if (!text.ends_with('#'))
      text += '#';
  }
  return text;
}

std::string endings_html(const ReportColumns& columns) {
  const CampaignTable& table = *columns.table;
  std::map<std::string, Ending> endings;
  for (const CampaignRow& row : table.runs) {
    Ending& ending = endings[row.outcome];
    ++ending.runs;
    if (row.success.value_or(false)) ++ending.successes;
  }
  std::vector<std::pair<std::string, Ending>> sorted(endings.begin(), endings.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second.runs > b.second.runs; });
  std::string html =
      "<div class=\"table\"><table><thead><tr><th>outcome</th><th>runs</th><th>share</th>"
      "<th>of these succeeded</th></tr></thead><tbody>";
  for (const auto& [name, ending] : sorted)
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td data-l=\"runs\">{}</td><td data-l=\"share\">{}</td>"
        "<td data-l=\"succeeded\">{}</td></tr>",
        escape_html(name), ending.runs, share_of(ending.runs, table.runs.size()), ending.successes);
  return html + "</tbody></table></div>" + reasons_html(table);
}

std::string worst_html(const ReportColumns& columns) {
  const CampaignTable& table = *columns.table;
  const std::size_t quality = quality_column(table);
  std::vector<const CampaignRow*> worst;
  for (const CampaignRow& row : table.runs)
    if (!row.success.value_or(false)) worst.push_back(&row);
  if (worst.empty()) return "<p>Every run succeeded.</p>";
  std::stable_sort(worst.begin(), worst.end(), [&](const CampaignRow* a, const CampaignRow* b) {
    return badness(*a, quality) > badness(*b, quality);
  });
  std::string html = "<div class=\"table\"><table>" + run_heading(columns) + "<tbody>";
  for (std::size_t k = 0; k < std::min(kMostRuns, worst.size()); ++k)
    html += run_html(columns, *worst[k]);
  html += "</tbody></table></div>";
  if (worst.size() > kMostRuns)
    html += fmt::format("<p class=\"soft\">The first {} of {} runs that did not succeed.</p>",
                        kMostRuns, worst.size());
  return html;
}

}  // namespace retiarius

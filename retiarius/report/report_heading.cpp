#include "retiarius/report/report_heading.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/report/report_plots.hpp"
#include "retiarius/report/svg_plot.hpp"

namespace retiarius {

namespace {

// Powers of ten as people write them: 1.9e-13 as 1.9 times 10 to the -13.
std::string raised(const std::string& exponent) {
  static const char* const kDigits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent[0] == '-' ? "\u207b" : "";
  const std::size_t first = exponent.find_first_not_of("+-0");
  for (char digit : exponent.substr(std::min(first, exponent.size() - 1)))
    text += kDigits[digit - '0'];
  return text;
}

std::string number_text(double value) {
  if (!std::isfinite(value)) return "\u2013";
  std::string text = fmt::format("{:.4g}", value);
  const std::size_t e = text.find('e');
  if (e != std::string::npos) text = text.substr(0, e) + "\u00b710" + raised(text.substr(e + 1));
  if (text[0] == '-') text.replace(0, 1, "\u2212");
  return text;
}

std::string title_html(const std::string& title) {
  return "<p class=\"brand\">Retiarius</p><h1>" + escape_html(title) + "</h1>";
}

}  // namespace

std::string spaced(std::string name) {
  for (char& c : name)
    if (c == '_') c = ' ';
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::string measure_html(const Measure& measure) {
  std::string value = "\u2013";
  if (const double* number = std::get_if<double>(&measure.value)) value = number_text(*number);
  if (const auto* count = std::get_if<std::int64_t>(&measure.value))
    value = fmt::format("{}", *count);
  if (const bool* truth = std::get_if<bool>(&measure.value)) value = *truth ? "yes" : "no";
  const std::string unit = value == "\u2013" ? "" : printed_unit(measure.unit);
  return value + (unit.empty() ? "" : " <small>" + escape_html(unit) + "</small>");
}

std::string outcome_html(const ReportData& data) {
  const char* outcome = to_string(data.run.outcome);
  std::string text =
      fmt::format("<p class=\"outcome {}\"><b>{}</b><span>", outcome, spaced(outcome));
  if (!data.run.reason.empty()) {
    text += escape_html(data.run.reason);
  } else if (!data.run.phases.empty()) {
    text += fmt::format("{} phase{}, {:.6g} s of mission time", data.run.phases.size(),
                        data.run.phases.size() == 1 ? "" : "s", data.run.phases.back().end);
  }
  return text + "</span></p>";
}

std::string cards_html(const Measures& measures) {
  std::string html;
  for (const char* name : {"success", "captured_share", "closed", "mouth_area_max",
                           "mouth_area_max_time", "peak_tension", "first_contact_time",
                           "smallest_distance", "linear_momentum_drift", "wall_time"})
    for (const Measure& measure : measures)
      if (measure.name == name && !std::holds_alternative<std::monostate>(measure.value))
        html += fmt::format("<div><dl><dt>{}</dt><dd>{}</dd></dl></div>", spaced(measure.name),
                            measure_html(measure));
  return html.empty() ? "" : "<div class=\"cards\">" + html + "</div>";
}

std::string heading_html(const ReportData& data) {
  return "<header class=\"top\">" + title_html(data.title.empty() ? "Mission" : data.title) +
         outcome_html(data) + cards_html(data.run.measures) + "</header>";
}

std::string comparison_heading_html(const std::vector<ComparedRun>& runs) {
  std::string html =
      "<header class=\"top\">" + title_html(fmt::format("Comparison of {} runs", runs.size()));
  for (const ComparedRun& run : runs)
    html += fmt::format("<section class=\"compared\"><h2>{}</h2>{}</section>",
                        escape_html(run.label), outcome_html(run.data));
  return html + "</header>";
}

}  // namespace retiarius

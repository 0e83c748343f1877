#include "program/outcome.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "program/text_table.hpp"

namespace retiarius::program {

namespace {

// The measures worth a line each; all of them are in summary.json.
constexpr std::array<std::string_view, 12> kKeyMeasures = {
    "success",           "captured_share",        "closed",       "mouth_area_max",
    "mouth_area_final",  "first_contact_time",    "peak_tension", "peak_strain",
    "smallest_distance", "linear_momentum_drift", "steps",        "newton_iterations"};

// Empty where the measure does not apply.
std::string value_text(const Measure& measure) {
  if (const double* number = std::get_if<double>(&measure.value))
    return quantity(*number, measure.unit);
  if (const std::int64_t* count = std::get_if<std::int64_t>(&measure.value))
    return fmt::format("{}", *count);
  if (const bool* truth = std::get_if<bool>(&measure.value)) return *truth ? "yes" : "no";
  return "";
}

const Measure* find(const Measures& measures, std::string_view name) {
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  return found == measures.end() ? nullptr : &*found;
}

std::string headline(const Mission& mission, const RunReport& report) {
  std::string text = to_string(report.outcome);
  if (!mission.title.empty()) text += ": " + mission.title;
  // Why a run failed is told as an error.
  if (report.outcome != Outcome::failed && !report.reason.empty()) text += "\n  " + report.reason;
  return text + "\n";
}

std::string pace(const RunReport& report) {
  const double simulated = report.phases.empty() ? 0.0 : report.phases.back().end;
  const Measure* wall = find(report.measures, "wall_time");
  if (wall == nullptr) return "";
  const double* seconds = std::get_if<double>(&wall->value);
  if (seconds == nullptr) return "";
  std::string text = fmt::format("  {:.6g} s simulated in {}", simulated, duration(*seconds));
  if (simulated > 0.0 && *seconds > 0.0)
    text += fmt::format(" ({:.2g} x real time)", simulated / *seconds);
  return text + "\n";
}

std::string phases(const RunReport& report) {
  if (report.phases.empty()) return "";
  TextTable table;
  table.add({"phase", "from", "to", "ended by"});
  for (const PhaseReport& phase : report.phases)
    table.add({phase.name, fmt::format("{:.6g} s", phase.start), fmt::format("{:.6g} s", phase.end),
               phase.trigger});
  return fmt::format("\n{}", table.text());
}

std::string measures(const RunReport& report) {
  TextTable table;
  for (const std::string_view name : kKeyMeasures) {
    const Measure* measure = find(report.measures, name);
    const std::string value = measure == nullptr ? "" : value_text(*measure);
    if (!value.empty()) table.add(measure->name, value);
  }
  return table.empty() ? "" : fmt::format("\n{}", table.text());
}

}  // namespace

std::string outcome_text(const Mission& mission, const RunReport& report) {
  return headline(mission, report) + pace(report) + phases(report) + measures(report);
}

std::string folder_text(const RunReport& report, const std::filesystem::path& folder) {
  std::string text = fmt::format("\nreport: {}\n", (folder / "report.html").string());
  if (report.outcome == Outcome::interrupted)
    text += fmt::format("to go on: retiarius resume {}\n", folder.string());
  return text;
}

ExitCode exit_code(Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return kOk;
    case Outcome::interrupted:
      return kInterrupted;
    case Outcome::failed:
    case Outcome::broke:
      return kFailed;
  }
  return kFailed;
}

}  // namespace retiarius::program

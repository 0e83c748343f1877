#include "retiarius/campaign/report_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/campaign/statistics_distribution.hpp"

namespace retiarius {

namespace {

// Measures that tell most about a capture, first; what is not named here follows.
constexpr std::array<std::string_view, 9> kTelling = {
    "capture_quality_settled", "captured_share",    "peak_tension_20ms",
    "mouth_area_max",          "mouth_width_final", "first_contact_time",
    "capture_quality_final",   "peak_tension",      "capture_quality_settling_time"};

// What says how the run was computed, not how the capture went.
constexpr std::array<std::string_view, 8> kOwnAffairs = {"success",
                                                         "steps",
                                                         "newton_iterations",
                                                         "substeps",
                                                         "wall_time",
                                                         "linear_momentum_drift",
                                                         "angular_momentum_drift",
                                                         "smallest_distance"};

void check(const CampaignTable& table) {
  for (std::size_t k = 0; k < table.runs.size(); ++k) {
    const CampaignRow& row = table.runs[k];
    if (row.inputs.size() != table.inputs.size() || row.measures.size() != table.measures.size())
      throw InputError(fmt::format(
          "run {} has {} inputs and {} measures, where the campaign names {} and {}", row.id,
          row.inputs.size(), row.measures.size(), table.inputs.size(), table.measures.size()));
    if (k > 0 && row.id <= table.runs[k - 1].id)
      throw InputError(
          fmt::format("run {} follows run {}; ids must ascend", row.id, table.runs[k - 1].id));
  }
}

bool varies(const std::vector<double>& values) {
  double first = std::numeric_limits<double>::quiet_NaN();
  for (double v : values) {
    if (!std::isfinite(v)) continue;
    if (std::isnan(first)) first = v;
    if (v != first) return true;
  }
  return false;
}

std::size_t place_of(const std::string& name) {
  return static_cast<std::size_t>(std::find(kTelling.begin(), kTelling.end(), name) -
                                  kTelling.begin());
}

void add_results(const CampaignTable& table, ReportColumns& columns) {
  for (std::size_t m = 0; m < table.measures.size(); ++m) {
    const std::string& name = table.measures[m];
    if (std::find(kOwnAffairs.begin(), kOwnAffairs.end(), name) != kOwnAffairs.end()) continue;
    CampaignResult result{name, {}, m};
    for (const CampaignRow* row : columns.runs) result.values.push_back(row->measures[m]);
    if (varies(result.values)) columns.results.push_back(std::move(result));
  }
  std::stable_sort(columns.results.begin(), columns.results.end(),
                   [](const CampaignResult& a, const CampaignResult& b) {
                     return place_of(a.name) < place_of(b.name);
                   });
}

void rank_inputs(ReportColumns& columns) {
  for (std::size_t i = 0; i < columns.inputs.size(); ++i)
    if (varies(columns.inputs[i])) columns.ranked.push_back(i);
  const CampaignResult* by = varies(columns.success.values) ? &columns.success
                             : columns.results.empty()      ? nullptr
                                                            : &columns.results.front();
  if (by == nullptr) return;
  std::vector<double> strength(columns.inputs.size(), 0.0);
  for (std::size_t i : columns.ranked)
    strength[i] = influence(columns.inputs[i], by->values).strength();
  std::stable_sort(columns.ranked.begin(), columns.ranked.end(),
                   [&](std::size_t a, std::size_t b) { return strength[a] > strength[b]; });
}

}  // namespace

ReportColumns report_columns(const CampaignTable& table) {
  check(table);
  ReportColumns columns;
  columns.table = &table;
  const auto width = static_cast<std::int64_t>(table.inputs.size()) + 2;
  for (const CampaignRow& row : table.runs)
    if (table.design != CampaignDesign::saltelli || row.id % width < 2)
      columns.runs.push_back(&row);
  columns.inputs.resize(table.inputs.size());
  columns.success = {"success", {}, kSuccess};
  for (const CampaignRow* row : columns.runs) {
    for (std::size_t i = 0; i < row->inputs.size(); ++i)
      columns.inputs[i].push_back(row->inputs[i]);
    columns.success.values.push_back(row->success ? (*row->success ? 1.0 : 0.0)
                                                  : std::numeric_limits<double>::quiet_NaN());
  }
  add_results(table, columns);
  rank_inputs(columns);
  return columns;
}

double Influence::strength() const {
  return std::isnan(correlation.rho) ? 0.0 : std::abs(correlation.rho);
}

std::string Influence::name(const std::string& input) const {
  return off_median ? input + " off its median" : input;
}

Influence influence(const std::vector<double>& input, const std::vector<double>& result) {
  const double median = distribution(input).median;
  std::vector<double> away;
  away.reserve(input.size());
  for (double v : input) away.push_back(std::abs(v - median));
  const Influence direct{rank_correlation(input, result), false};
  const Influence folded{rank_correlation(away, result), true};
  return folded.strength() > direct.strength() ? folded : direct;
}

std::vector<Influence> influences(const ReportColumns& columns, const CampaignResult& result) {
  std::vector<Influence> found;
  for (std::size_t i : columns.ranked) found.push_back(influence(columns.inputs[i], result.values));
  return found;
}

std::vector<std::size_t> strongest_first(const std::vector<Influence>& found) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!std::isnan(found[k].correlation.rho)) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return found[a].strength() > found[b].strength();
  });
  return order;
}

std::string short_number(double value) {
  if (!std::isfinite(value)) return "\u2013";
  std::string text = fmt::format("{:.4g}", value);
  if (text[0] == '-') text.replace(0, 1, "\u2212");
  return text;
}

std::string percent_text(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

}  // namespace retiarius

#include "retiarius/record/history_csv.hpp"

#include <cmath>
#include <iterator>
#include <limits>

#include <fmt/format.h>

namespace retiarius {

std::vector<std::string> history_header(const Mission& mission) {
  std::vector<std::string> names;
  for (const HistoryColumn& column : history_columns()) names.push_back(column.name);
  for (const ProbeSpec& probe : mission.probes)
    for (const char* part : {"x", "y", "z", "fx", "fy", "fz"})
      names.push_back(probe.name + "." + part);
  for (const BodySpec& target : mission.targets)
    for (const char* part : {"contact_fx", "contact_fy", "contact_fz", "normal", "friction"})
      names.push_back(target.name + "." + part);
  return names;
}

std::vector<double> history_values(const HistoryRow& row) {
  std::vector<double> values;
  values.reserve(history_columns().size() + 6 * row.probes.size() + 5 * row.loads.size());
  for (const HistoryColumn& column : history_columns()) values.push_back(column.value(row));
  for (const ProbeValue& probe : row.probes) {
    values.insert(values.end(), probe.position.begin(), probe.position.end());
    values.insert(values.end(), probe.force.begin(), probe.force.end());
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const BodyLoad& load : row.loads) {
    values.insert(values.end(), load.force.begin(), load.force.end());
    values.insert(values.end(), {load.normal.value_or(none), load.friction.value_or(none)});
  }
  return values;
}

std::string csv_line(const std::vector<double>& values) {
  std::string line;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) line += ',';
    if (!std::isnan(values[k])) fmt::format_to(std::back_inserter(line), "{}", values[k]);
  }
  line += '\n';
  return line;
}

HistoryCsv::HistoryCsv(const std::filesystem::path& folder) : file_(folder / "history.csv") {}

void HistoryCsv::begin(const RunModel& model) {
  file_.write(fmt::format("{}\n", fmt::join(history_header(*model.mission), ",")));
}

void HistoryCsv::history(const HistoryRow& row) { file_.write(csv_line(history_values(row))); }

void HistoryCsv::end(const RunReport&) { file_.sync(); }

}  // namespace retiarius

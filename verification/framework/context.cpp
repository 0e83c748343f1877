#include "verification/framework/context.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/reader.hpp"
#include "verification/framework/case.hpp"

namespace retiarius::verification {

namespace {

class Recorder final : public Observer {
 public:
  explicit Recorder(MissionRun& run) : run_(run) {}
  void history(const HistoryRow& row) override { run_.rows.push_back(row); }
  void frame(const Frame& frame) override { run_.frames.push_back(*frame.state); }
  void checkpoint(const State& state) override { run_.last = state; }

 private:
  MissionRun& run_;
};

const Measure& find(const Measures& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m;
  throw Error(fmt::format("the run has no measure {}", name));
}

// NaN for what is no number.
double number(const std::string& cell) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  return end == cell.c_str() ? std::numeric_limits<double>::quiet_NaN() : value;
}

template <typename T>
T value_of(const Measures& measures, const std::string& name) {
  const auto& value = find(measures, name).value;
  if (!std::holds_alternative<T>(value))
    throw Error(fmt::format("the measure {} is absent or of another type", name));
  return std::get<T>(value);
}

}  // namespace

const HistoryRow& MissionRun::at(double time) const {
  for (const HistoryRow& row : rows)
    if (std::abs(row.time - time) < 1e-9) return row;
  throw Error(fmt::format("the history has no row at {} s", time));
}

std::vector<double> MissionRun::times() const { return column(&HistoryRow::time); }

std::vector<double> MissionRun::column(double HistoryRow::*value) const {
  std::vector<double> result;
  for (const HistoryRow& row : rows) result.push_back(row.*value);
  return result;
}

double MissionRun::measure(const std::string& name) const {
  return value_of<double>(report.measures, name);
}

bool MissionRun::flag(const std::string& name) const {
  return value_of<bool>(report.measures, name);
}

const std::vector<double>& Table::operator[](const std::string& name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw Error(fmt::format("the table has no column {}", name));
  return columns[static_cast<std::size_t>(at - names.begin())];
}

const std::string& Context::file(const std::string& name) const {
  const std::string path = case_.name + "/" + name;
  const auto at = embedded_files().find(path);
  if (at == embedded_files().end()) throw Error(fmt::format("there is no file {}", path));
  return at->second;
}

Mission Context::mission(const std::string& name, const std::vector<std::string>& overrides) const {
  return parse_mission(file(name + ".toml"), case_.name + "/" + name + ".toml", ".", overrides);
}

MissionRun Context::run(const Mission& mission, bool may_fail) const {
  MissionRun run;
  run.mission = mission;
  spoil(fault_, run.mission.contact);
  for (PhaseSpec& phase : run.mission.phases) spoil(fault_, phase.contact);
  auto model = std::make_shared<MissionModel>(run.mission);
  spoil(fault_, model->network);
  run.model = model;
  Recorder recorder(run);
  RunOptions options;
  options.wrap_law = law_wrapper(fault_);
  run.report = run_mission(run.mission, *run.model, recorder, options);
  if (run.report.outcome != Outcome::finished && !may_fail)
    throw RunError(fmt::format("the mission \"{}\" {}: {}", mission.title,
                               to_string(run.report.outcome), run.report.reason));
  return run;
}

MissionRun Context::run(const std::string& name, const std::vector<std::string>& overrides) const {
  return run(mission(name, overrides));
}

Simulation Context::simulation(Network& network, const std::vector<Body>& bodies) const {
  spoil(fault_, network);
  return Simulation(network, bodies, initial_state(network, bodies), law_wrapper(fault_));
}

ContactSpec Context::contact(ContactSpec spec) const {
  spoil(fault_, spec);
  return spec;
}

std::unique_ptr<Law> Context::law(std::unique_ptr<Law> law) const {
  const LawWrapper wrap = law_wrapper(fault_);
  return wrap ? wrap(std::move(law)) : std::move(law);
}

Table Context::table(const std::string& name) const {
  Table table;
  std::istringstream lines(file(name + ".csv"));
  std::string line, cell;
  while (std::getline(lines, line)) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells(line);
    if (table.names.empty()) {
      while (std::getline(cells, cell, ',')) table.names.push_back(cell);
      table.columns.resize(table.names.size());
      continue;
    }
    for (std::vector<double>& column : table.columns) {
      if (!std::getline(cells, cell, ','))
        throw Error(fmt::format("{}.csv: too few numbers in \"{}\"", name, line));
      column.push_back(number(cell));
    }
  }
  return table;
}

void Context::compare(ErrorKind kind, const std::string& quantity, const std::string& unit,
                      double ours, double reference, double bound, const std::string& argument,
                      const std::string& source) {
  result_.comparisons.push_back({quantity, unit, ours, reference, kind, bound,
                                 source.empty() ? case_.source : source, argument});
}

void Context::relative(const std::string& quantity, const std::string& unit, double ours,
                       double reference, double bound, const std::string& argument,
                       const std::string& source) {
  compare(ErrorKind::relative, quantity, unit, ours, reference, bound, argument, source);
}

void Context::absolute(const std::string& quantity, const std::string& unit, double ours,
                       double reference, double bound, const std::string& argument,
                       const std::string& source) {
  compare(ErrorKind::absolute, quantity, unit, ours, reference, bound, argument, source);
}

}  // namespace retiarius::verification

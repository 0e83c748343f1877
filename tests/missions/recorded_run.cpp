#include "tests/missions/recorded_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>

namespace retiarius::testing {

namespace {

class Recorder final : public Observer {
 public:
  explicit Recorder(RecordedRun& run) : run_(run) {}
  void history(const HistoryRow& row) override { run_.rows.push_back(row); }
  void checkpoint(const State& state) override { run_.last = state; }

 private:
  RecordedRun& run_;
};

RecordedRun run_whole(const Mission& mission) {
  RecordedRun run{mission, MissionModel(mission), {}, {}, {}};
  Recorder recorder(run);
  run.report = run_mission(run.mission, run.model, recorder);
  return run;
}

const Measure& find(const Measures& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m;
  throw std::runtime_error("no measure " + name);
}

}  // namespace

const HistoryRow& RecordedRun::at(double time) const {
  for (const HistoryRow& row : rows)
    if (std::abs(row.time - time) < 1e-9) return row;
  throw std::runtime_error("no row at " + std::to_string(time));
}

RecordedRun run_file(const std::string& name, const std::vector<std::string>& overrides) {
  const std::string path = std::string(RETIARIUS_SOURCE_DIR) + "/missions/" + name + ".toml";
  return run_whole(read_mission(path, overrides));
}

RecordedRun run_text(const std::string& text, const std::vector<std::string>& overrides) {
  return run_whole(parse_mission(text, "mission", ".", overrides));
}

double number(const Measures& measures, const std::string& name) {
  return std::get<double>(find(measures, name).value);
}

bool flag(const Measures& measures, const std::string& name) {
  return std::get<bool>(find(measures, name).value);
}

double energy_turned_over(const std::vector<HistoryRow>& rows) {
  double sum = 0.0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    sum += std::abs(rows[k].kinetic_energy - rows[k - 1].kinetic_energy);
  return sum;
}

double energy_made(const std::vector<HistoryRow>& rows) {
  double sum = 0.0;
  for (std::size_t k = 1; k < rows.size(); ++k)
    sum += std::max(0.0, rows[k - 1].integrator_loss - rows[k].integrator_loss);
  return sum;
}

void expect_sound(const RecordedRun& run) {
  EXPECT_EQ(run.report.outcome, Outcome::finished) << run.report.reason;
  EXPECT_EQ(run.report.phases.size(), run.mission.phases.size());
  const double turned_over = energy_turned_over(run.rows);
  EXPECT_GT(turned_over, 0.0);
  EXPECT_LT(energy_made(run.rows), 0.01 * turned_over);
  ASSERT_FALSE(run.rows.empty());
  EXPECT_GE(run.rows.back().friction_loss, 0.0);
  EXPECT_GE(run.rows.back().impact_loss, 0.0);
}

}  // namespace retiarius::testing

// Runs missions for tests and keeps what they tell.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "retiarius/mission/observer.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"

namespace retiarius::testing {

// A whole run: what was built, every row of its history, its last state and its report.
struct RecordedRun {
  Mission mission;
  MissionModel model;
  std::vector<HistoryRow> rows;
  State last;
  RunReport report;

  // The row at `time`; throws where there is none.
  const HistoryRow& at(double time) const;
};

// Runs missions/NAME.toml with overrides.
RecordedRun run_file(const std::string& name, const std::vector<std::string>& overrides = {});

// Runs a mission given as text.
RecordedRun run_text(const std::string& text, const std::vector<std::string>& overrides = {});

// A measure by its name; throws where it is absent or not of this type.
double number(const Measures& measures, const std::string& name);
bool flag(const Measures& measures, const std::string& name);

// Sum of the absolute changes of kinetic energy from row to row, J: energy that went to or came
// from any other line of the account. A body that flies on unchanged turns over nothing.
double energy_turned_over(const std::vector<HistoryRow>& rows);

// Sum of the decreases of integrator_loss from row to row, J: energy that the integrator made.
double energy_made(const std::vector<HistoryRow>& rows);

// What every mission must show: it finished without failure, all phases ran, the integrator made
// less than 1 % of the energy turned over, friction and impacts only take energy.
void expect_sound(const RecordedRun& run);

}  // namespace retiarius::testing

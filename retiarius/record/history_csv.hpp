// history.csv: one row per output time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "retiarius/mission/observer.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius {

// Names of all columns of a mission's history: history_columns(), then six for each probe
// and five for each target.
std::vector<std::string> history_header(const Mission& mission);

// Values of one row in the order of history_header; NaN where absent.
std::vector<double> history_values(const HistoryRow& row);

// One line of comma-separated values with its line end: shortest decimal numbers that read back
// to the same double, nothing between the commas for NaN.
std::string csv_line(const std::vector<double>& values);

// Writes the file row by row: each row is handed to the operating system before the run goes on.
class HistoryCsv : public Observer {
 public:
  explicit HistoryCsv(const std::filesystem::path& folder);  // throws RunError

  void begin(const RunModel& model) override;
  void history(const HistoryRow& row) override;
  void end(const RunReport& report) override;

 private:
  OutputFile file_;
};

}  // namespace retiarius

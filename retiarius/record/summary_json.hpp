// summary.json: outcome, phases, measures, versions.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "retiarius/base/build_info.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius {

// Name of a phase's kind as the mission file writes it.
const char* phase_kind_name(PhaseKind kind);

// Host and clock values; they differ from run to run and comparisons drop them.
struct Timings {
  std::string host;
  std::string started;   // UTC, ISO 8601
  std::string finished;  // UTC, ISO 8601
  double wall_seconds = 0.0;
};

// The file's text. `model` may be empty (a run that failed before it was built).
std::string summary_text(const RunModel& model, const RunReport& report, const BuildInfo& build,
                         const Timings& timings);

// Writes the file once, when the run ends, whatever its outcome.
class SummaryJson : public Observer {
 public:
  SummaryJson(const std::filesystem::path& folder, BuildInfo build);

  void begin(const RunModel& model) override;
  void end(const RunReport& report) override;

 private:
  std::filesystem::path path_;
  BuildInfo build_;
  RunModel model_;
  std::chrono::system_clock::time_point started_;
};

}  // namespace retiarius

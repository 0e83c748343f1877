// A convergence study: which results of a mission hold when step and mesh are refined.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/mission/run.hpp"
#include "retiarius/study/judgement.hpp"
#include "retiarius/study/levels.hpp"
#include "retiarius/study/quantities.hpp"

namespace retiarius {

struct ConvergeOptions {
  double tolerance = 0.02;                  // of relative changes
  const std::atomic<bool>* stop = nullptr;  // as in RunOptions
  std::optional<State> net_state;           // as in RunOptions
  Log log;
  // Sees the run of a level beside the study; may return null. May be empty.
  std::function<Observer*(std::size_t level)> watch;
};

// What one level gave.
struct LevelResult {
  Outcome outcome = Outcome::finished;
  std::string reason;  // why it failed; empty otherwise
  double wall_time = 0.0;
  std::vector<HistoryRow> rows;
  std::vector<Quantity> quantities;  // none where it failed

  // It came to its end; a thread that broke is a result, not a failure.
  bool usable() const { return outcome == Outcome::finished || outcome == Outcome::broke; }
};

// A quantity along a series.
struct Trend {
  std::string name, unit;
  double size = 0.0;           // as in Quantity, the largest over the levels
  std::vector<double> values;  // at each level of the series, NaN where it has none
  Judgement judgement;
};

struct SeriesResult {
  std::vector<Trend> trends;
  // How many have the verdict.
  std::size_t count(Verdict verdict) const;
  // "16 of 22 quantities hold at 2 %, 4 do not, 2 are chaotic"
  std::string summary(double tolerance) const;
};

struct Study {
  Plan plan;
  double tolerance = 0.0;
  std::vector<LevelResult> levels;   // one for each of the plan's
  std::vector<SeriesResult> series;  // likewise
  bool interrupted = false;
};

// Runs every level, one after the other. A level that fails is told in its result and leaves NaN in
// the trends; once `stop` is set no further one begins. Throws InputError where the mission itself
// does not fit (see check_run).
Study converge(const Plan& plan, const ConvergeOptions& options = {});

}  // namespace retiarius

// What a run tells while it goes on. The writers of record/ are observers; so may be users' own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/base/archive.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/measure/history.hpp"
#include "retiarius/measure/measures.hpp"
#include "retiarius/mission/choices.hpp"
#include "retiarius/mission/mission.hpp"
#include "retiarius/motion/work_times.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

enum class Outcome { finished, failed, interrupted, broke };
const char* to_string(Outcome outcome);

// What was built from the mission; lives as long as the run.
struct RunModel {
  const Mission* mission = nullptr;
  const Network* network = nullptr;
  const std::vector<Body>* bodies = nullptr;
  std::vector<PhaseChoice> choices;  // of each phase
  std::string start_report;          // what automatic choices were made, a line each, and why
  // The run goes on from a checkpoint: all up to there is told again first, then resumed().
  bool resumed = false;
};

struct PhaseReport {
  std::string name;
  PhaseKind kind = PhaseKind::free;
  double start = 0.0, end = 0.0;  // s
  std::string trigger;            // what ended it: its `until`, or why it broke off
  Measures measures;
};

void transfer(Archive& archive, PhaseReport& report);  // see base/archive.hpp

struct RunReport {
  Outcome outcome = Outcome::finished;
  std::string reason;  // empty when finished
  std::vector<PhaseReport> phases;
  Measures measures;  // of the whole run; wall_time among them
  WorkTimes work;     // of this run, from where it was resumed if it was
};

// What a run is resumed from: the state, and all else that steers what follows.
struct Checkpoint {
  State state;
  std::int64_t rows = 0;    // of the history, told up to here
  std::int64_t frames = 0;  // told up to here
  bool ended = false;       // the run has come to its end: there is nothing to resume
  bool fresh = true;        // the net started as designed, not from a saved state
  std::string progress;     // of the mission; empty: the state is all that was saved
};

class Observer {
 public:
  virtual ~Observer() = default;

  virtual void begin(const RunModel&) {}
  virtual void history(const HistoryRow&) {}  // at output times
  virtual void frame(const Frame&) {}         // at frame times
  // At phases' starts, after each frame, where the run is stopped from outside, at the end, at
  // intervals of wall time. `durable`: what was told so far is to outlive the machine, not only the
  // process; at most one in a few seconds is.
  virtual void save(const Checkpoint& saved, bool /*durable*/) { checkpoint(saved.state); }
  virtual void checkpoint(const State&) {}  // the same, for those who look at the state alone
  virtual void resumed() {}                 // see RunModel::resumed
  virtual void progress(const State&, Index /*phase*/, double /*phase_fraction*/) {}  // each step
  virtual void end(const RunReport&) {}
};

}  // namespace retiarius

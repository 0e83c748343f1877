// What a run tells while it goes on. The writers of record/ are observers; so may be users' own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/measure/history.hpp"
#include "retiarius/measure/measures.hpp"
#include "retiarius/mission/mission.hpp"
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
  std::string start_report;  // what automatic choices were made, a line each
};

struct PhaseReport {
  std::string name;
  PhaseKind kind = PhaseKind::free;
  double start = 0.0, end = 0.0;  // s
  std::string trigger;            // what ended it: its `until`, or why it broke off
  Measures measures;
};

struct RunReport {
  Outcome outcome = Outcome::finished;
  std::string reason;  // empty when finished
  std::vector<PhaseReport> phases;
  Measures measures;  // of the whole run; wall_time among them
};

class Observer {
 public:
  virtual ~Observer() = default;

  virtual void begin(const RunModel&) {}
  virtual void history(const HistoryRow&) {}  // at output times
  virtual void frame(const Frame&) {}         // at frame times
  virtual void checkpoint(const State&) {}  // at phase ends, at intervals of wall time, at the end
  virtual void progress(const State&, Index /*phase*/, double /*phase_fraction*/) {}  // each step
  virtual void end(const RunReport&) {}
};

}  // namespace retiarius

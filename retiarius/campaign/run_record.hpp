// What is recorded of one run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/measure/measures.hpp"

namespace retiarius {

// Words of RunRecord::outcome, beside "finished", "broke" and "failed" of a run that ended by
// itself: limit (of mission time or steps), timeout (of the wall clock), refused (its inputs make
// no mission, or a file that it names is bad), killed (its process died every time).
struct RunRecord {
  // Equal for every engine, machine and order:
  std::int64_t id = 0;
  std::int64_t seed = 0;
  std::vector<double> inputs;
  std::string outcome, reason;
  std::optional<bool> success;  // absent where the run did not come to an answer
  Measures measures;            // finite numbers; without wall_time and success
  std::string missing;   // why measures are absent that are no finite numbers; empty: none is
  std::string versions;  // of the program, with kernels
  std::string command;   // repeats the run
  std::string kept;      // folder of its results, relative to the campaign's; or empty
  // Not compared:
  std::string host, engine, started;  // started: UTC, ISO 8601
  double wall_time = 0.0;             // s
  std::int64_t attempts = 1;
};

}  // namespace retiarius

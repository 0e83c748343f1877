// Whole missions, as `retiarius run` computes them but with nothing written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace retiarius::benchmarks {

struct MissionTime {
  std::string name;       // the file's, without folder and ending
  std::string overrides;  // joined by blanks
  std::string outcome;
  int threads = 1;
  double simulated = 0.0;  // s
  double seconds = 0.0;    // wall time
  std::int64_t steps = 0, iterations = 0, unconverged = 0;
};

// Throws InputError as reading and running the mission do.
MissionTime time_mission(const std::string& file, const std::vector<std::string>& overrides);

}  // namespace retiarius::benchmarks

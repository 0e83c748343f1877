// The line that tells how far a run is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "retiarius/mission/mission.hpp"

namespace retiarius::program {

// What the line shows.
struct ProgressValues {
  std::string phase;            // its name
  int number = 1, count = 1;    // of the phase, and of all
  double time = 0.0;            // simulated, s
  std::optional<double> end;    // of the mission at the latest, s; absent: nobody knows
  std::optional<double> speed;  // simulated over real time; absent: too early to tell
};

// "[=====>    ]  52 %  close 4/5  t = 1.284 s  0.42 x real time  12 s left", which fits into 80
// columns. Share and time left are those up to the latest end: phases may end earlier. Without a
// known end both are missing.
std::string progress_text(const ProgressValues& values);

// The mission time at which the last phase ends at the latest; none where a phase may go on.
std::optional<double> latest_end(const Mission& mission);

}  // namespace retiarius::program

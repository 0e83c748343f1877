// What the comparison with another engine yields.
#pragma once

#include <chrono>
#include <string>

#include "verification/framework/recorded.hpp"

namespace retiarius::verification {

// Seconds of the clock since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The scenes; each adds its comparisons, times, and a paragraph about itself.
void hanging_net(Recorded& recorded);
void swinging_chain(Recorded& recorded);

// As lines of text, and as results.csv (framework/recorded.hpp).
std::string outcome_text(const Recorded& recorded);
std::string outcome_csv(const Recorded& recorded);

// False where a difference is beyond its bound or not finite.
bool within_bounds(const Recorded& recorded);

}  // namespace retiarius::verification

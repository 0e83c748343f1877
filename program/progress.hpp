// Shows on the terminal how far a run is.
#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "retiarius/mission/observer.hpp"

namespace retiarius::program {

// Rewrites one status line at most ten times a second and removes it at the end. Speed is that of
// the last seconds: phases differ in what a step costs.
class Progress : public Observer {
 public:
  void begin(const RunModel& model) override;
  void progress(const State& state, Index phase, double phase_fraction) override;
  void end(const RunReport& report) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Sample {
    Clock::time_point real;
    double simulated;
  };

  std::optional<double> speed(const Sample& now);

  const Mission* mission_ = nullptr;
  std::optional<double> end_;
  Clock::time_point shown_;
  std::deque<Sample> samples_;  // of the last seconds, the oldest first
};

}  // namespace retiarius::program

// Watches the limits of one run.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "retiarius/campaign/spec.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius {

enum class Reached { none, time, steps, wall_clock, outside };

// Sets stopping() when a limit is reached or `outside` is set; to be told every step.
class RunLimits : public Observer {
 public:
  RunLimits(const LimitSpec& limits, const std::atomic<bool>* outside)
      : limits_(limits), outside_(outside) {}

  void progress(const State& state, Index phase, double phase_fraction) override;

  const std::atomic<bool>& stopping() const { return stop_; }
  Reached reached() const { return reached_; }
  // "its mission time reached the limit of 3 s"
  std::string text() const;

 private:
  using Clock = std::chrono::steady_clock;

  LimitSpec limits_;
  const std::atomic<bool>* outside_;
  std::atomic<bool> stop_{false};
  Reached reached_ = Reached::none;
  std::int64_t steps_ = 0;
  Clock::time_point started_ = Clock::now();
};

}  // namespace retiarius

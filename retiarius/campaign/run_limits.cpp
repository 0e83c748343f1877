#include "retiarius/campaign/run_limits.hpp"

#include <fmt/format.h>

namespace retiarius {

void RunLimits::progress(const State& state, Index, double) {
  ++steps_;
  if (stop_) return;
  const std::chrono::duration<double> wall = Clock::now() - started_;
  if (outside_ && *outside_) {
    reached_ = Reached::outside;
  } else if (state.time >= limits_.time * (1.0 - 1e-12)) {
    reached_ = Reached::time;
  } else if (limits_.steps > 0 && steps_ >= limits_.steps) {
    reached_ = Reached::steps;
  } else if (wall.count() >= limits_.wall_clock) {
    reached_ = Reached::wall_clock;
  }
  if (reached_ != Reached::none) stop_ = true;
}

std::string RunLimits::text() const {
  switch (reached_) {
    case Reached::time:
      return fmt::format("its mission time reached the limit of {:.6g} s", limits_.time);
    case Reached::steps:
      return fmt::format("it reached the limit of {} steps", limits_.steps);
    case Reached::wall_clock:
      return fmt::format("it reached the limit of {:.6g} s of wall clock", limits_.wall_clock);
    default:
      return {};
  }
}

}  // namespace retiarius

#include "program/progress.hpp"

#include "program/console.hpp"
#include "program/progress_text.hpp"

namespace retiarius::program {

namespace {

constexpr auto kBetweenLines = std::chrono::milliseconds(100);
constexpr auto kSpeedWindow = std::chrono::seconds(10);
constexpr double kShortestWindow = 0.3;  // s; a speed over less would jump about

}  // namespace

void Progress::begin(const RunModel& model) {
  mission_ = model.mission;
  end_ = latest_end(*mission_);
  samples_ = {{Clock::now(), 0.0}};
}

std::optional<double> Progress::speed(const Sample& now) {
  samples_.push_back(now);
  while (samples_.size() > 2 && now.real - samples_[1].real > kSpeedWindow) samples_.pop_front();
  const std::chrono::duration<double> real = now.real - samples_.front().real;
  if (real.count() < kShortestWindow) return std::nullopt;
  return (now.simulated - samples_.front().simulated) / real.count();
}

void Progress::progress(const State& state, Index phase, double) {
  const auto now = Clock::now();
  if (now - shown_ < kBetweenLines) return;
  shown_ = now;
  ProgressValues values;
  values.phase = mission_->phases[static_cast<std::size_t>(phase)].name;
  values.number = phase + 1;
  values.count = static_cast<int>(mission_->phases.size());
  values.time = state.time;
  values.end = end_;
  values.speed = speed({now, state.time});
  show_status(progress_text(values));
}

void Progress::end(const RunReport&) { show_status(""); }

}  // namespace retiarius::program

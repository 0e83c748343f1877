#include "program/progress_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "program/text_table.hpp"
#include "retiarius/mission/trigger.hpp"

namespace retiarius::program {

namespace {

std::string bar(double share) {
  constexpr int kWidth = 10;
  share = std::clamp(share, 0.0, 1.0);
  const int done = static_cast<int>(share * kWidth);
  std::string text(kWidth, ' ');
  std::fill_n(text.begin(), done, '=');
  if (done < kWidth) text[static_cast<std::size_t>(done)] = '>';
  return fmt::format("[{}] {:3.0f} %", text, 100.0 * share);
}

}  // namespace

std::string progress_text(const ProgressValues& values) {
  std::string text;
  if (values.end && *values.end > 0.0) text += bar(values.time / *values.end) + "  ";
  text +=
      fmt::format("{} {}/{}  t = {:.3f} s", values.phase, values.number, values.count, values.time);
  if (!values.speed || !(*values.speed > 0.0)) return text;
  text += fmt::format("  {:.2g} x real time", *values.speed);
  if (values.end)
    text += fmt::format("  {} left",
                        duration(std::max(0.0, *values.end - values.time) / *values.speed));
  return text;
}

std::optional<double> latest_end(const Mission& mission) {
  double time = 0.0;
  for (const PhaseSpec& phase : mission.phases) {
    if (phase.integrator.method == Method::static_solve) continue;  // takes no simulated time
    const auto end = Trigger::parse(phase.until, phase.place).latest_time(time);
    if (!end) return std::nullopt;
    time = std::max(time, *end);
  }
  return time;
}

}  // namespace retiarius::program

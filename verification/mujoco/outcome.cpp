#include "verification/mujoco/outcome.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace retiarius::verification {

namespace {

std::string number(double value) {
  return std::isnan(value) ? std::string(1, '-') : fmt::format("{:.10g}", value);
}

}  // namespace

std::string outcome_text(const Recorded& recorded) {
  std::string text = fmt::format("{:<5}{:<62} {:>14} {:>14} {:>10}    {}\n", "", "quantity",
                                 "Retiarius", "MuJoCo", "difference", "bound");
  for (const RecordedComparison& c : recorded.comparisons)
    text += fmt::format("{:<5}{:<62} {:>14} {:>14} {:>10.2g} <= {:.2g} {}\n",
                        c.difference <= c.bound ? "ok" : "MISS", c.scene + ": " + c.quantity,
                        number(c.ours), number(c.theirs), c.difference, c.bound, c.unit);
  for (const RecordedScene& s : recorded.scenes)
    text += fmt::format("{}: {:.3g} s by Retiarius, {:.3g} s by MuJoCo\n", s.name, s.our_time,
                        s.their_time);
  return text;
}

std::string outcome_csv(const Recorded& recorded) {
  std::string text;
  for (const std::string& about : recorded.about) text += fmt::format("# {}\n", about);
  for (const RecordedScene& s : recorded.scenes)
    text += fmt::format("scene,{},{:.3g},{:.3g}\n", s.name, s.our_time, s.their_time);
  for (const RecordedComparison& c : recorded.comparisons)
    text += fmt::format("value,{},{},{},{},{},{:.3g},{:.3g}\n", c.scene, c.quantity, c.unit,
                        number(c.ours), number(c.theirs), c.difference, c.bound);
  return text;
}

bool within_bounds(const Recorded& recorded) {
  return !recorded.comparisons.empty() &&
         std::all_of(recorded.comparisons.begin(), recorded.comparisons.end(),
                     [](const RecordedComparison& c) { return c.difference <= c.bound; });
}

}  // namespace retiarius::verification

#include "retiarius/campaign/stop_rule.hpp"

#include <algorithm>

#include "retiarius/campaign/shard.hpp"
#include "retiarius/campaign/statistics.hpp"

namespace retiarius {

void StopRule::update(const std::vector<std::uint8_t>& states) {
  if (spec_.width <= 0.0) return;
  while (!end_ && seen_ < runs_) {
    const std::uint8_t state = states[static_cast<std::size_t>(seen_)];
    if (state == kNotDone) return;
    ++seen_;
    if (state != kNoAnswer) ++answers_;
    if (state == kSuccess) ++successes_;
    if (seen_ % spec_.batch != 0) continue;
    if (wilson_interval(successes_, answers_, spec_.confidence).width() < spec_.width) end_ = seen_;
  }
}

std::int64_t StopRule::horizon() const {
  if (spec_.width <= 0.0) return runs_;
  const std::int64_t decided = seen_ / spec_.batch;
  return std::min(end(), (decided + 2) * spec_.batch);
}

}  // namespace retiarius

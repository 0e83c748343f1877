#include "retiarius/campaign/run_queue.hpp"

#include <algorithm>

namespace retiarius {

RunQueue::RunQueue(const StopSpec& stop, std::vector<std::uint8_t> states, std::int64_t first,
                   std::int64_t last)
    : states_(std::move(states)),
      first_(first),
      last_(last),
      cursor_(first),
      rule_(stop, static_cast<std::int64_t>(states_.size())) {
  rule_.update(states_);
  for (std::int64_t id = first_; id < last_; ++id)
    if (states_[static_cast<std::size_t>(id)] != kNotDone) ++done_;
}

void RunQueue::skip() {
  while (cursor_ < last_ && states_[static_cast<std::size_t>(cursor_)] != kNotDone) ++cursor_;
}

std::optional<std::int64_t> RunQueue::next() {
  skip();
  if (cursor_ >= std::min(last_, rule_.horizon())) return std::nullopt;
  ++under_way_;
  return cursor_++;
}

void RunQueue::done(std::int64_t id, RunState state) {
  states_[static_cast<std::size_t>(id)] = state;
  --under_way_;
  ++done_;
  rule_.update(states_);
}

bool RunQueue::finished() {
  skip();
  return under_way_ == 0 && cursor_ >= std::min(last_, rule_.end());
}

std::int64_t RunQueue::to_do() const {
  return std::max<std::int64_t>(0, std::min(last_, rule_.end()) - first_);
}

}  // namespace retiarius

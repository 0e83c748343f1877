// Which run is next.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "retiarius/campaign/shard.hpp"
#include "retiarius/campaign/stop_rule.hpp"

namespace retiarius {

// Hands out, in ascending order, the ids of the runs that are not done.
class RunQueue {
 public:
  // Of the ids from `first` to before `last`.
  RunQueue(const StopSpec& stop, std::vector<std::uint8_t> states, std::int64_t first,
           std::int64_t last);

  // None: there is nothing to begin now; see finished().
  std::optional<std::int64_t> next();
  void done(std::int64_t id, RunState state);

  // Nothing is left to begin and nothing is under way.
  bool finished();

  const StopRule& rule() const { return rule_; }
  const std::vector<std::uint8_t>& states() const { return states_; }
  std::int64_t count_done() const { return done_; }  // of the range, up to the end of the rule
  std::int64_t to_do() const;                        // of the range, done or not

 private:
  void skip();

  std::vector<std::uint8_t> states_;
  std::int64_t first_, last_;
  std::int64_t cursor_;
  std::int64_t under_way_ = 0, done_ = 0;
  StopRule rule_;
};

}  // namespace retiarius

// When a campaign knows enough.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "retiarius/campaign/spec.hpp"

namespace retiarius {

// Decides on the runs 0 ... n - 1 alone, for n one batch after another, once all of them are done;
// so the decision is the same whichever runs ended first. Runs without an answer are left out of
// the rate.
class StopRule {
 public:
  StopRule(const StopSpec& spec, std::int64_t runs) : spec_(spec), runs_(runs) {}

  // Looks at what is done by now (a RunState for every run).
  void update(const std::vector<std::uint8_t>& states);

  // The first run that does not count: where the rule said stop, else the number of runs.
  std::int64_t end() const { return end_.value_or(runs_); }
  bool stopped() const { return end_.has_value(); }

  // Runs below this may be begun: two batches beyond what is decided, so that nobody waits.
  std::int64_t horizon() const;

 private:
  StopSpec spec_;
  std::int64_t runs_;
  std::int64_t seen_ = 0;  // runs looked at, all of them done
  std::int64_t successes_ = 0, answers_ = 0;
  std::optional<std::int64_t> end_;
};

}  // namespace retiarius

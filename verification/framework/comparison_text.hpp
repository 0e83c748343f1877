// Comparisons as they are printed on pages: with as many digits as their bounds give sense to.
#pragma once

#include <string>

#include "verification/framework/ladder.hpp"
#include "verification/framework/results.hpp"

namespace retiarius::verification {

// Ours and the reference, to the last place that the bound reaches, at most ten digits: what
// round-off decides is not shown, so that pages do not depend on the machine.
std::string ours_text(const Comparison& c);
std::string reference_text(const Comparison& c);

// "3.1·10^-5 rel.", "0.0021 m"; errors at the level of round-off, or below a hundredth of the
// bound, where the end of an iteration may decide, are told as smaller than a limit.
std::string error_text(const Comparison& c);
std::string bound_text(const Comparison& c);

// A number with the given significant digits, with a power of ten where it is small or large.
std::string printed(double value, int digits);

// The unit after a blank; empty for "1".
std::string unit_text(const std::string& unit);

// "ok", "MISS", "FAILED", "drawn" (no published values).
std::string verdict_word(const CaseResult& result);

struct Tally {
  std::size_t cases = 0, passed = 0, comparisons = 0, within = 0;
};
Tally tally(const std::vector<Rung>& rungs);

}  // namespace retiarius::verification

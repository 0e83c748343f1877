// verification.html: the results of the cases as one self-contained page.
#pragma once

#include <string>

#include "verification/framework/ladder.hpp"
#include "verification/framework/recorded.hpp"

namespace retiarius::verification {

struct PageOptions {
  bool quick = false;
  double wall_time = 0.0;  // s, of all cases together
  Recorded recorded;       // comparisons with other programs; may be empty
};

// Verdict, contents by group, then each case: about, charts, comparisons with the arguments for
// their bounds, notes. Light or dark after the reader's preference; no scripts, no references to
// anything outside.
std::string verification_page(const std::vector<Rung>& rungs, const PageOptions& options);

}  // namespace retiarius::verification

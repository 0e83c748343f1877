// docs/verification.md: the results of the cases as a document.
#pragma once

#include <string>

#include "verification/framework/ladder.hpp"
#include "verification/framework/recorded.hpp"

namespace retiarius::verification {

// What verification is, how to repeat it, a summary, then each case. Holds nothing that depends on
// the machine: the same program gives the same text everywhere. Charts are links to
// FIGURES/<figure_name>.
std::string results_markdown(const std::vector<Rung>& rungs, const Recorded& recorded,
                             const std::string& figures, bool quick);

// "heavy-cantilever-1.svg" for the first chart of the case.
std::string figure_name(const Case& of, std::size_t chart);

}  // namespace retiarius::verification

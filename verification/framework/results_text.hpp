// The results of cases as text for the terminal.
#pragma once

#include <string>

#include "verification/framework/ladder.hpp"

namespace retiarius::verification {

// One line a case: name, title, figure of the paper.
std::string list_text(const std::vector<const Case*>& cases);

// The heading of a case, a line for each comparison, notes and failure.
std::string case_text(const Rung& rung);

// How many cases and comparisons passed, and which did not.
std::string verdict_text(const std::vector<Rung>& rungs);

// A number with as many digits as a comparison needs.
std::string number_text(double value);

}  // namespace retiarius::verification

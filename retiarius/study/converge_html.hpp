// A convergence study as one self-contained page.
#pragma once

#include <string>

#include "retiarius/study/converge.hpp"

namespace retiarius {

// converge.html: which measures hold, the levels with their outcomes, then for each series its
// charts and every quantity's values, change, order and verdict.
std::string converge_html(const Study& study);

}  // namespace retiarius

// A convergence study as JSON.
#pragma once

#include <string>

#include "retiarius/study/converge.hpp"

namespace retiarius {

// converge.json: levels with outcome, cost and time; for each series every quantity with its values
// from coarse to fine, change, order, limit and verdict. Absent numbers are null.
std::string converge_json(const Study& study);

}  // namespace retiarius

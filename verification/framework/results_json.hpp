// The results of cases as JSON.
#pragma once

#include <string>

#include "verification/framework/ladder.hpp"

namespace retiarius::verification {

// verification.json: version and build, every case with its comparisons, curves, notes and time.
// Numbers that are not finite are null.
std::string results_json(const std::vector<Rung>& rungs, bool quick);

}  // namespace retiarius::verification

// What `retiarius verify` leaves behind.
#pragma once

#include <filesystem>
#include <vector>

#include "program/exit_code.hpp"
#include "verification/framework/ladder.hpp"

namespace retiarius::program {

// Writes verification.html, .json, .md and figures/*.svg into the folder, which is made where it
// is missing; `wall_time` in s. Returns kFailed where a case missed a bound or broke off.
ExitCode conclude(const std::vector<verification::Rung>& rungs, const std::filesystem::path& out,
                  bool quick, double wall_time);

}  // namespace retiarius::program

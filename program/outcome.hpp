// What `retiarius run` says when a run has ended.
#pragma once

#include <filesystem>
#include <string>

#include "program/exit_code.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius::program {

// How it ended and how long it took, its phases, and its key measures, in aligned columns.
std::string outcome_text(const Mission& mission, const RunReport& report);

// Where the results are and, of a run that can go on, how.
std::string folder_text(const RunReport& report, const std::filesystem::path& folder);

ExitCode exit_code(Outcome outcome);

}  // namespace retiarius::program

// What `retiarius run` says when a run has ended.
#pragma once

#include <string>

#include "program/exit_code.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius::program {

// How it ended and how long it took, its phases, and its key measures, in aligned columns.
std::string outcome_text(const Mission& mission, const RunReport& report);

ExitCode exit_code(Outcome outcome);

}  // namespace retiarius::program

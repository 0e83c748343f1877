// What `retiarius converge` says.
#pragma once

#include <string>

#include "retiarius/study/converge.hpp"

namespace retiarius::program {

// Before the runs: which they are, with steps and nodes, and what they cost together, in runs of
// the mission as given.
std::string plan_text(const Plan& plan);

// One line when a level has ended.
std::string level_text(const Level& level, const LevelResult& result);

// For each series the quantities of the whole run with their values, change, order and verdict, and
// how many of all hold.
std::string study_text(const Study& study);

}  // namespace retiarius::program

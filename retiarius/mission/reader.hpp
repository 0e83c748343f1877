// From a mission file to a Mission: read, overridden, defaulted, checked.
#pragma once

#include <string>
#include <vector>

#include "retiarius/mission/mission.hpp"

namespace retiarius {

// Reads a mission file and applies overrides ("net.thread.radius=0.004", see set_override.hpp).
// Throws InputError with file, line and column, the key, its value and what is allowed; for an
// override its text stands in place of file and line.
Mission read_mission(const std::string& path, const std::vector<std::string>& overrides = {});

// The same from text; `name` stands for the file in messages, relative paths start from `folder`.
Mission parse_mission(const std::string& text, const std::string& name = "mission",
                      const std::string& folder = ".",
                      const std::vector<std::string>& overrides = {});

// What is allowed but looks like a mistake, such as a radius given in millimetres; a sentence each.
std::vector<std::string> mission_warnings(const Mission& mission);

}  // namespace retiarius

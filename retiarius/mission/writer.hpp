// A mission as text: the file with every default filled in, the file's documentation, a first
// file to start from.
#pragma once

#include <string>

#include "retiarius/mission/mission.hpp"

namespace retiarius {

// The resolved mission: every key that belongs, with units as comments; absent values are comments.
// Reads back to the same mission; paths are absolute, so that it may lie anywhere.
std::string to_toml(const Mission& mission);

// docs/mission-file.md, from the schema.
std::string mission_file_markdown();

// A commented, complete, runnable mission: a small hexagon net shot at a sphere.
std::string starter_mission(const std::string& name);

}  // namespace retiarius

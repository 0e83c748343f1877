// One value of a mission file, checked against its key.
#pragma once

#include <string>

#include <toml++/toml.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/key.hpp"

namespace retiarius {

// Throws InputError at `place` naming `path`, the value, and what the key allows.
KeyValue read_value(const toml::node& node, const KeyInfo& key, const std::string& path,
                    const SourcePlace& place);

// The value as it would be written in the file, for messages; long ones are cut.
std::string node_text(const toml::node& node);

}  // namespace retiarius

// Missions that the tests of this room start from.
#pragma once

#include <string>

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/reader.hpp"

namespace retiarius {

// The least that is a mission: every required key and nothing else.
inline const std::string kLeast = R"([net]
pattern = "hexagon"
side = 1.0
mesh = 0.2

[net.thread]
young_modulus = 1.0e6
density = 1000.0
radius = 0.01

[[phase]]
kind = "free"
until = "time >= 2.0"
)";

// The text of the InputError that a mission makes; empty if it reads.
inline std::string error_of(const std::string& text,
                            const std::vector<std::string>& overrides = {}) {
  try {
    parse_mission(text, "m.toml", ".", overrides);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

// kLeast with one piece of text replaced.
inline std::string with(const std::string& old_text, const std::string& new_text,
                        std::string base = kLeast) {
  const auto at = base.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return base.replace(at, old_text.size(), new_text);
}

}  // namespace retiarius

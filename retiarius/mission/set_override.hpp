// Overrides of single keys from the command line: --set net.thread.radius=0.004.
#pragma once

#include <string>

#include <toml++/toml.h>

namespace retiarius {

// Puts "path=value" into a mission's root table. The path is dotted with zero-based brackets
// ("phase[0].half_angle_deg"; target and target[0] are the same); missing tables are made, and an
// array grows by one where its length is the index; brackets after the key of a list of numbers
// stand for one of them ("target.position[0]"). The value is TOML; where the schema says that
// the key is a text or a word it may stand without quotes. What is put in carries the override as
// its source. Throws InputError that begins with "--set path=value: ".
void apply_override(toml::table& root, const std::string& override_text);

}  // namespace retiarius

// The text of a TOML file that a user wrote, and its syntax. Only sources of the library include
// it, for it shows the TOML library.
#pragma once

#include <string>

#include <toml++/toml.h>

namespace retiarius {

// What messages call the file.
struct TomlFileKind {
  std::string name;   // "mission"
  std::string needs;  // what an empty one lacks, "a mission needs at least ..."
};

// The whole file. Throws InputError where it is no readable file of at most 16 MiB.
std::string read_toml_file(const std::string& path, const TomlFileKind& kind);

// Throws InputError with the place of a syntax error, or where the text is empty or not text.
toml::table parse_toml(const std::string& text, const std::string& name, const TomlFileKind& kind);

}  // namespace retiarius

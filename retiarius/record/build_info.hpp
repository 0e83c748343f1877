// What the results say about the program that made them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace retiarius {

// Filled by the program, which alone knows how it was built.
struct BuildInfo {
  std::string version;
  std::string compiler;
  std::string build_type;
  std::vector<std::pair<std::string, std::string>> options;    // name, value; in order
  std::string kernels;                                         // which code paths computed
  std::vector<std::pair<std::string, std::string>> libraries;  // name, version; in order
};

}  // namespace retiarius

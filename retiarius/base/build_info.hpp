// What this library is: version, source revision, compiler, options; written into every result.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace retiarius {

struct BuildInfo {
  std::string version;     // of Retiarius, "major.minor.patch"
  std::string revision;    // git description; empty where not built from a checkout
  std::string compiler;    // name and version
  std::string build_type;  // of CMake: Release, Debug, RelWithDebInfo
  std::vector<std::pair<std::string, std::string>> options;  // name, value: what can change results
  std::string kernels;                                       // code paths: portable or native
  std::vector<std::pair<std::string, std::string>> libraries;  // name, version
};

const BuildInfo& build_info();

}  // namespace retiarius

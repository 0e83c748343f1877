// What this library is: version, source revision, compiler, options; written into every result.
#pragma once

#include <string>
#include <vector>

namespace retiarius {

struct BuildInfo {
  std::string version;                 // of Retiarius, "major.minor.patch"
  std::string revision;                // git description; empty where not built from a checkout
  std::string compiler;                // name and version
  std::string build_type;              // of CMake: Release, Debug, RelWithDebInfo
  std::vector<std::string> options;    // "name=value": what can change results or speed
  std::vector<std::string> libraries;  // "name version" of the libraries it was built with
};

const BuildInfo& build_info();

}  // namespace retiarius

// A recorded run as the checker sees it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/check/checked_solid.hpp"
#include "retiarius/record/run_file.hpp"

namespace retiarius::check {

struct CheckedRun {
  RunFile file;
  std::vector<std::array<Index, 2>> segments;
  std::vector<double> radius, rest_length;  // of each segment
  std::vector<std::string> names;           // of the bodies
  std::vector<std::unique_ptr<CheckedSolid>> solids;
  std::vector<bool> self;  // of each phase: whether the mission has thread on thread there

  // Throws InputError.
  explicit CheckedRun(const std::filesystem::path& folder);
};

}  // namespace retiarius::check

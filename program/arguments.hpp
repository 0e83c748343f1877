// Arguments that several commands share.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "retiarius/mission/mission.hpp"

namespace retiarius::program {

// The validator without its text in the help, where the option's type says it already.
CLI::Validator quiet(CLI::Validator validator);

// MISSION and --set.
struct MissionArguments {
  std::string file;
  std::vector<std::string> overrides;

  void add_to(CLI::App& command);
  // Reads the mission and tells its warnings on stderr. Throws InputError.
  Mission read() const;
};

// --threads and --kernels.
struct ComputingArguments {
  int threads = 0;  // 0: as many as the machine has
  std::string kernels = "auto";

  void add_to(CLI::App& command);
  // Sets both for the whole process. Throws InputError for kernels that this machine lacks.
  void apply() const;
};

}  // namespace retiarius::program

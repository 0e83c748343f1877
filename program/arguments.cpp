#include "program/arguments.hpp"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "program/console.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/mission/reader.hpp"

namespace retiarius::program {

CLI::Validator quiet(CLI::Validator validator) { return validator.description(""); }

void MissionArguments::add_to(CLI::App& command) {
  command.add_option("MISSION", file, "Mission file (TOML)")->required()->type_name("");
  command
      .add_option("--set", overrides,
                  "Override one key, e.g. net.thread.radius=0.004; may be given again")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

Mission MissionArguments::read() const {
  Mission mission = read_mission(file, overrides);
  for (const std::string& warning : mission_warnings(mission)) tell_warning(warning);
  return mission;
}

void ComputingArguments::add_to(CLI::App& command) {
  command
      .add_option("--threads", threads,
                  "Threads to compute with; results do not depend on it (default: all)")
      ->type_name("N")
      ->check(quiet(CLI::Range(1, 4096)));
  command
      .add_option("--kernels", kernels,
                  "Code paths of the solver; results differ in the last digits (default: auto)")
      ->type_name("auto|portable|avx2|avx512")
      ->check(quiet(CLI::IsMember({"auto", "portable", "avx2", "avx512"})));
}

void ComputingArguments::apply() const {
  set_threads(threads > 0 ? threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  try {
    set_kernels(kernels);
  } catch (const Error& error) {
    throw InputError(fmt::format("--kernels {}: {}", kernels, error.what()));
  }
}

}  // namespace retiarius::program

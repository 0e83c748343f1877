#include "program/campaign_slurm.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "program/arguments.hpp"
#include "program/console.hpp"
#include "retiarius/campaign/slurm_script.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius::program {

namespace fs = std::filesystem;

namespace {

void submit(const fs::path& script) {
  flush_output();
  const pid_t child = ::fork();
  if (child == 0) {
    ::execlp("sbatch", "sbatch", script.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child)
    throw RunError("cannot start sbatch; submit the script by hand");
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    throw RunError("there is no sbatch here; submit the script where Slurm is");
  throw RunError("sbatch did not take the job; see what it says above");
}

}  // namespace

void SlurmArguments::add_to(CLI::App& command) {
  command
      .add_option("--batch", batch,
                  "Slurm: runs of one task of the array (default: as many as make 100 tasks)")
      ->type_name("N")
      ->check(quiet(CLI::PositiveNumber));
  command.add_flag("--submit", submit, "Slurm: hand the job to sbatch");
  command
      .add_option("--sbatch", options,
                  "Slurm: a further option for sbatch, e.g. --sbatch=--partition=long; may be "
                  "given again")
      ->type_name("OPTION")
      ->allow_extra_args(false);
}

void write_slurm_job(const Campaign& campaign, const fs::path& folder,
                     const SlurmArguments& arguments) {
  constexpr std::int64_t kTasks = 100;
  SlurmSettings settings;
  settings.program = own_program();
  settings.campaign = fs::absolute(campaign.spec().file).lexically_normal().string();
  settings.folder = fs::absolute(folder).lexically_normal().string();
  settings.name = fs::path(settings.campaign).stem().string();
  settings.runs = campaign.plan().runs();
  settings.batch = arguments.batch > 0 ? arguments.batch : (settings.runs + kTasks - 1) / kTasks;
  settings.options = arguments.options;
  const fs::path script = fs::path(settings.folder) / "slurm" / "job.sh";
  std::error_code error;
  fs::create_directories(script.parent_path(), error);
  if (error)
    throw InputError(fmt::format("{}: {}", script.parent_path().string(), error.message()));
  write_atomically(script, slurm_script(settings));
  print(fmt::format("job: {}\n", script.string()));
  if (arguments.submit) {
    submit(script);
  } else {
    print(fmt::format("submit it with: sbatch {}\n", script.string()));
  }
  print(fmt::format("then: retiarius campaign status, and collect when all runs are done\n"));
}

}  // namespace retiarius::program

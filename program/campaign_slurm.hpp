// A campaign handed to Slurm.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "retiarius/campaign/campaign.hpp"

namespace retiarius::program {

struct SlurmArguments {
  std::int64_t batch = 0;  // runs of a task; 0: as many as make 100 tasks
  bool submit = false;
  std::vector<std::string> options;

  void add_to(CLI::App& command);
};

// Writes DIR/slurm/job.sh, and submits it where told so. Throws RunError where sbatch fails.
void write_slurm_job(const Campaign& campaign, const std::filesystem::path& folder,
                     const SlurmArguments& arguments);

// The file that this program is.
std::string own_program();

}  // namespace retiarius::program

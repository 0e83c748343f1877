// A campaign as a job array of Slurm.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace retiarius {

struct SlurmSettings {
  std::string program;   // absolute path, the same on every node
  std::string campaign;  // file, absolute
  std::string folder;    // of the results, absolute, on a file system that all nodes share
  std::string name;      // of the job
  std::int64_t runs = 0;
  std::int64_t batch = 1;            // ids of a task
  std::vector<std::string> options;  // further ones of sbatch: "--partition=long"
};

// The script for sbatch: task t does the runs from t batch to before (t + 1) batch, each task on
// one processor; a task that is lost with its node is put into the queue again and goes on where
// it was.
std::string slurm_script(const SlurmSettings& settings);

}  // namespace retiarius

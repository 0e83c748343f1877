#include "retiarius/campaign/slurm_script.hpp"

#include <fmt/format.h>

namespace retiarius {

namespace {

std::string quoted_word(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string slurm_script(const SlurmSettings& s) {
  const std::int64_t tasks = (s.runs + s.batch - 1) / s.batch;
  std::string out = "#!/bin/sh\n";
  out += fmt::format("#SBATCH --job-name={}\n", s.name);
  out += fmt::format("#SBATCH --array=0-{}\n", tasks - 1);
  out += "#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --requeue\n";
  out += "#SBATCH --open-mode=append\n";
  out += fmt::format("#SBATCH --output={}/slurm/%a.log\n", s.folder);
  for (const std::string& option : s.options) out += fmt::format("#SBATCH {}\n", option);
  out += fmt::format("first=$((SLURM_ARRAY_TASK_ID * {}))\n", s.batch);
  out += fmt::format("last=$((first + {}))\n", s.batch - 1);
  out += fmt::format("if [ \"$last\" -ge {0} ]; then last={1}; fi\n", s.runs, s.runs - 1);
  out += fmt::format(
      "exec {} campaign run {} --out {} --engine processes --name slurm --jobs 1 --quiet \\\n"
      "  --ids \"$first-$last\"\n",
      quoted_word(s.program), quoted_word(s.campaign), quoted_word(s.folder));
  return out;
}

}  // namespace retiarius

#include "tests/campaign/small_campaign.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "retiarius/campaign/sqlite.hpp"

namespace retiarius::testing {

namespace fs = std::filesystem;

namespace {

constexpr const char* kVariables = R"(
[[variable]]
name = "x"
set = "target.position[0]"
distribution = "uniform"
low = -0.2
high = 0.2
[[variable]]
name = "attitude"
set = "target.attitude_deg"
distribution = "uniform-attitude"
[[variable]]
name = "spin"
set = "target.spin_deg"
distribution = "cone"
half_angle_deg = 30
length = 20
)";

}  // namespace

void write_small_campaign(const WorkFolder& folder, const std::string& plan,
                          const std::string& more) {
  fs::copy_file(fs::path(RETIARIUS_SOURCE_DIR) / "tests/campaign/small-mission.toml",
                folder / "m.toml", fs::copy_options::overwrite_existing);
  folder.write("c.toml", "mission = \"m.toml\"\n[plan]\n" + plan + kVariables + more);
}

std::string monte_carlo(int runs) {
  return fmt::format("design = \"monte-carlo\"\nruns = {}\nseed = 11\n", runs);
}

std::string rows_of(const WorkFolder& folder, const std::string& out) {
  Database database(folder / out / "campaign.sqlite");
  int columns = 0;
  {
    Statement info = database.prepare("PRAGMA table_info(runs)");
    while (info.step()) ++columns;
  }
  std::string text;
  Statement rows = database.prepare("SELECT * FROM runs ORDER BY id");
  while (rows.step()) {
    for (int at = 0; at < columns; ++at) text += rows.text(at) + "|";
    text += "\n";
  }
  return text;
}

std::string query(const WorkFolder& folder, const std::string& out, const std::string& sql) {
  Database database(folder / out / "campaign.sqlite");
  Statement rows = database.prepare(sql);
  return rows.step() ? rows.text(0) : "";
}

bool has_mpi() { return std::string(RETIARIUS_MPIEXEC).size() > 0; }

ProcessResult mpirun(const WorkFolder& folder, int ranks,
                     const std::vector<std::string>& arguments) {
  std::string command = fmt::format(
      "cd '{}' && OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 '{}' --oversubscribe "
      "-n {} '{}'",
      folder.path().string(), RETIARIUS_MPIEXEC, ranks, RETIARIUS_PROGRAM);
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  const fs::path out = folder / "mpirun.out";
  const int status = std::system((command + " > '" + out.string() + "' 2>&1").c_str());
  ProcessResult result;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  result.out = folder.read("mpirun.out");
  return result;
}

std::vector<pid_t> children_of(pid_t process) {
  std::ifstream file(fmt::format("/proc/{0}/task/{0}/children", process));
  std::vector<pid_t> children;
  for (pid_t child = 0; file >> child;) children.push_back(child);
  return children;
}

}  // namespace retiarius::testing

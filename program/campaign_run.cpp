// retiarius campaign run and resume.
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/campaign_arguments.hpp"
#include "program/campaign_mpi.hpp"
#include "program/campaign_slurm.hpp"
#include "program/console.hpp"
#include "program/interruption.hpp"
#include "program/text_table.hpp"
#include "retiarius/campaign/collect.hpp"
#include "retiarius/campaign/process_engine.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
  CampaignArguments campaign;
  std::string engine = "auto", ids, name = "processes";
  int jobs = 0;
  bool quiet = false, resume = false;
  SlurmArguments slurm;
};

// "A-B" or "A": ids from A to B.
void set_range(EngineSettings& settings, const std::string& ids, std::int64_t runs) {
  settings.last = runs;
  if (ids.empty()) return;
  try {
    std::size_t used = 0;
    settings.first = std::stoll(ids, &used);
    settings.last = settings.first + 1;
    if (used < ids.size() && ids[used] == '-') {
      const std::string rest = ids.substr(used + 1);
      settings.last = std::stoll(rest, &used) + 1;
      used += ids.size() - rest.size();
    }
    if (used != ids.size()) throw std::invalid_argument(ids);
  } catch (const std::logic_error&) {
    throw InputError(fmt::format("--ids {}: must be an id or two with a dash, as in 0-99", ids));
  }
  if (settings.first < 0 || settings.first >= settings.last || settings.last > runs)
    throw InputError(fmt::format("--ids {}: ids go from 0 to {}", ids, runs - 1));
}

// Shows how many runs are done on the status line.
class CampaignProgress {
 public:
  void operator()(RunQueue& queue) {
    if (!status_possible()) return;
    const auto now = Clock::now();
    if (begun_ == Clock::time_point{}) {
      begun_ = now;
      done_before_ = queue.count_done();
    }
    if (std::chrono::duration<double>(now - shown_).count() < 0.2) return;
    shown_ = now;
    const std::int64_t done = queue.count_done(), all = queue.to_do();
    std::string text = fmt::format("{} of {} runs", std::min(done, all), all);
    const double elapsed = std::chrono::duration<double>(now - begun_).count();
    if (done > done_before_)
      text += fmt::format(", {} left", duration(elapsed / static_cast<double>(done - done_before_) *
                                                static_cast<double>(all - done)));
    show_status(text);
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begun_{}, shown_{};
  std::int64_t done_before_ = 0;
};

std::string engine_of(const RunArguments& arguments) {
  if (arguments.engine != "auto") return arguments.engine;
  return under_mpi() ? "mpi" : "processes";
}

ExitCode finish(const RunArguments& arguments, const Campaign& campaign, const fs::path& folder,
                bool done) {
  show_status("");
  if (!done) {
    if (!arguments.quiet)
      print(fmt::format("stopped; `retiarius campaign resume {}` goes on\n",
                        arguments.campaign.file));
    return kInterrupted;
  }
  if (!arguments.ids.empty()) return kOk;
  collect(campaign, folder);
  if (arguments.quiet) return kOk;
  print(status_text(campaign, folder));
  print(fmt::format("\nresults: {}\n", (folder / "campaign.sqlite").string()));
  return kOk;
}

ExitCode run(const RunArguments& arguments) {
  make_write_failures_errors();
  const Campaign campaign(arguments.campaign.file);
  const fs::path folder = arguments.campaign.folder();
  if (arguments.resume && !fs::is_directory(folder / "shards"))
    throw InputError(fmt::format("{}: holds no campaign to resume; see `retiarius campaign run`",
                                 folder.string()));
  prepare_campaign_folder(folder);
  const std::string engine = engine_of(arguments);
  if (engine == "slurm") {
    write_slurm_job(campaign, folder, arguments.slurm);
    return kOk;
  }
  EngineSettings settings;
  settings.program = own_program();
  settings.folder = folder;
  settings.jobs = arguments.jobs > 0
                      ? arguments.jobs
                      : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  set_range(settings, arguments.ids, campaign.plan().runs());
  settings.engine = engine == "mpi" ? engine : arguments.name;
  settings.stop = &catch_interruptions();
  if (!arguments.quiet) settings.progress = CampaignProgress();
  if (engine == "mpi") {
    return run_mpi(campaign, settings,
                   [&](bool done) { return finish(arguments, campaign, folder, done); });
  }
  // Tasks of a cluster share the folder, each with ids of its own.
  std::optional<CampaignLock> lock;
  if (arguments.ids.empty()) lock.emplace(folder);
  return finish(arguments, campaign, folder, run_processes(campaign, settings));
}

void add_run_options(CLI::App& command, RunArguments& arguments) {
  arguments.campaign.add_to(command);
  command
      .add_option("--jobs", arguments.jobs, "Runs at a time on this machine (default: a core each)")
      ->type_name("N")
      ->check(quiet(CLI::Range(1, 4096)));
  command
      .add_option("--engine", arguments.engine,
                  "Who does the runs: processes of this machine, the ranks of mpirun, or a job "
                  "array of Slurm (default: mpi under mpirun, else processes)")
      ->type_name("auto|processes|mpi|slurm")
      ->check(quiet(CLI::IsMember({"auto", "processes", "mpi", "slurm"})));
  command.add_option("--ids", arguments.ids, "These runs alone, e.g. 0-99")->type_name("A-B");
  command.add_option("--name", arguments.name)->group("");
  command.add_flag("--quiet", arguments.quiet, "Print nothing but warnings and errors");
  arguments.slurm.add_to(command);
  command.footer(
      "Exit codes: 0 all runs are done, whatever their outcomes; 1 results cannot be written;\n"
      "2 wrong usage or input; 4 interrupted: `retiarius campaign resume` goes on.");
}

}  // namespace

std::string own_program() { return fs::read_symlink("/proc/self/exe").string(); }

void add_campaign_run(CLI::App& campaign, ExitCode& code) {
  for (const bool resume : {false, true}) {
    CLI::App* command = campaign.add_subcommand(
        resume ? "resume" : "run", resume ? "Go on with a campaign that was interrupted"
                                          : "Do all runs that are not done yet");
    auto arguments = std::make_shared<RunArguments>();
    arguments->resume = resume;
    add_run_options(*command, *arguments);
    command->callback([arguments, &code] { code = run(*arguments); });
  }
}

}  // namespace retiarius::program

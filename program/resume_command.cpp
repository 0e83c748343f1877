// retiarius resume DIR: goes on with a run that was interrupted or died.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/interruption.hpp"
#include "program/outcome.hpp"
#include "program/progress.hpp"
#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/folder_lock.hpp"
#include "retiarius/record/resume.hpp"
#include "retiarius/report/run_recorders.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct ResumeArguments {
  std::string folder;
  int threads = 0;
  bool quiet = false;
};

// Those that the run was begun with, whatever this machine would choose.
void take_kernels(const std::string& name) {
  try {
    set_kernels(name);
  } catch (const Error& error) {
    throw InputError(fmt::format("cannot resume the run: it was begun with the kernels {}: {}",
                                 name, error.what()));
  }
}

RunOptions run_options(const fs::path& folder, const ResumableRun& run) {
  RunOptions options;
  options.stop = &catch_interruptions();
  options.resume = resumption(folder, run);
  options.log = [](LogLevel level, const std::string& text) {
    if (level == LogLevel::warning) tell_warning(text);
  };
  return options;
}

ExitCode go_on(const ResumeArguments& arguments, const fs::path& folder, const ResumableRun& run) {
  take_kernels(run.saved.identity.kernels);
  RecordOptions record;
  record.resolved = read_whole_file(folder / "resolved.toml");
  record.build = build_info();
  record.build.kernels = kernel_name();
  record.resume = true;
  RunIdentity identity = run_identity(record);
  check_identity(run.saved.identity, identity);
  const Mission mission = parse_mission(record.resolved, (folder / "resolved.toml").string(),
                                        fs::absolute(folder).string());
  const MissionModel model(mission);
  identity.model = model_hash(model.network, model.bodies);
  check_identity(run.saved.identity, identity);
  const RunOptions options = run_options(folder, run);
  check_run(mission, model, options);
  if (!run.passed_over.empty())
    tell_warning(fmt::format("{}; {} is used", run.passed_over, run.used.string()));

  const std::unique_ptr<FanOut> observers = make_run_recorders(folder, record);
  if (!arguments.quiet && status_possible()) observers->add(std::make_unique<Progress>());
  const RunReport report = run_mission(mission, model, *observers, options);
  show_status("");
  if (report.outcome == Outcome::failed) tell_error(report.reason);
  if (!arguments.quiet) {
    print(outcome_text(mission, report));
    print(folder_text(report, folder));
  }
  return exit_code(report.outcome);
}

ExitCode resume(const ResumeArguments& arguments) {
  make_write_failures_errors();
  set_threads(arguments.threads > 0
                  ? arguments.threads
                  : std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  const fs::path folder = arguments.folder;
  const FolderLock lock(folder);
  const ResumableRun run = find_resumable(folder);
  if (run.saved.checkpoint.ended) {
    if (!arguments.quiet)
      print(fmt::format("{}: the run has finished; there is nothing to resume\n", folder.string()));
    return kOk;
  }
  return go_on(arguments, folder, run);
}

}  // namespace

void add_resume_command(CLI::App& app, ExitCode& code) {
  CLI::App* command = app.add_subcommand(
      "resume", "Go on with a run that was interrupted, or whose process or machine died");
  auto arguments = std::make_shared<ResumeArguments>();
  command->add_option("DIR", arguments->folder, "Folder of the run")->required()->type_name("");
  command
      ->add_option("--threads", arguments->threads,
                   "Threads to compute with; results do not depend on it (default: all)")
      ->type_name("N")
      ->check(quiet(CLI::Range(1, 4096)));
  command->add_flag("--quiet", arguments->quiet, "Print nothing but warnings and errors");
  command->footer(
      "The folder ends up as that of a run that was never interrupted, timings aside. Mission,\n"
      "program and kernels must be those that began it.\n"
      "Exit codes: 0 finished, now or before; 1 the run failed or a thread broke; 2 the folder\n"
      "cannot be resumed; 4 interrupted again.");
  command->callback([arguments, &code] { code = resume(*arguments); });
}

}  // namespace retiarius::program

// retiarius run MISSION: simulates it and leaves a folder of results.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/interruption.hpp"
#include "program/live_server.hpp"
#include "program/outcome.hpp"
#include "program/output_guard.hpp"
#include "program/progress.hpp"
#include "program/start_state.hpp"
#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/mission/writer.hpp"
#include "retiarius/record/checkpoint.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/folder_lock.hpp"
#include "retiarius/record/output_folder.hpp"
#include "retiarius/report/run_recorders.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct RunArguments {
  MissionArguments mission;
  ComputingArguments computing;
  std::string out, start;
  bool quiet = false, live = false;
  ServerArguments server;
};

fs::path output_folder(const RunArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return fs::path("out") / fs::path(arguments.mission.file).stem();
}

RunOptions run_options(const RunArguments& arguments, const Mission& mission) {
  RunOptions options;
  options.stop = &catch_interruptions();
  options.net_state = net_state(mission);
  if (!arguments.start.empty()) options.start = read_checkpoint(arguments.start);
  options.log = [](LogLevel level, const std::string& text) {
    if (level == LogLevel::warning) tell_warning(text);
  };
  return options;
}

// Prints what was chosen for the run.
class Choices : public Observer {
 public:
  void begin(const RunModel& model) override {
    print(model.start_report);
    flush_output();
  }
};

// All that writes results or shows progress.
std::unique_ptr<Observer> make_observers(const RunArguments& arguments, const Mission& mission,
                                         const fs::path& out) {
  RecordOptions options;
  options.resolved = to_toml(mission);
  options.mission = read_whole_file(arguments.mission.file);
  options.build = build_info();
  options.build.kernels = kernel_name();
  std::unique_ptr<FanOut> observers = make_run_recorders(out, options);
  if (!arguments.quiet) observers->add(std::make_unique<Choices>());
  if (!arguments.quiet && status_possible()) observers->add(std::make_unique<Progress>());
  return observers;
}

void tell_outcome(const RunArguments& arguments, const Mission& mission, const RunReport& report,
                  const fs::path& out) {
  show_status("");
  if (report.outcome == Outcome::failed) tell_error(report.reason);
  if (arguments.quiet) return;
  print(outcome_text(mission, report));
  print(folder_text(report, out));
}

std::unique_ptr<LiveServer> start_server(const RunArguments& arguments, const Mission& mission,
                                         const fs::path& out) {
  if (!arguments.live) return {};
  auto server = std::make_unique<LiveServer>(out, mission.title, arguments.server);
  print(fmt::format("live: {}\n", server->address()));
  flush_output();
  return server;
}

ExitCode run(const RunArguments& arguments) {
  make_write_failures_errors();
  arguments.computing.apply();
  const Mission mission = arguments.mission.read();
  check_memory(estimate(mission));
  const fs::path out = output_folder(arguments);
  OutputGuard guard(out);
  prepare_output_folder(out);
  const FolderLock lock(out);
  const RunOptions options = run_options(arguments, mission);
  const MissionModel model(mission);
  check_run(mission, model, options);

  const std::unique_ptr<LiveServer> server = start_server(arguments, mission, out);

  // Up to here nothing was written; from here on the run has begun.
  guard.keep();
  const std::unique_ptr<Observer> observers = make_observers(arguments, mission, out);
  const RunReport report = run_mission(mission, model, *observers, options);
  tell_outcome(arguments, mission, report, out);
  if (server) server->let_watchers_finish();
  return exit_code(report.outcome);
}

}  // namespace

void add_run_command(CLI::App& app, ExitCode& code) {
  CLI::App* command = app.add_subcommand("run", "Simulate a mission");
  auto arguments = std::make_shared<RunArguments>();
  arguments->mission.add_to(*command);
  command
      ->add_option("--out", arguments->out,
                   "Folder for the results, new or empty; default out/<mission>")
      ->type_name("DIR");
  command
      ->add_option("--start", arguments->start,
                   "Start from the state that a run saved: its folder, or a checkpoint file")
      ->type_name("DIR_OR_FILE");
  arguments->computing.add_to(*command);
  command->add_flag("--quiet", arguments->quiet, "Print nothing but warnings and errors");
  command->add_flag("--live", arguments->live,
                    "Show the run in a browser while it goes on, at the address that is printed");
  arguments->server.add_to(*command, "--live");
  command->footer(
      "Exit codes: 0 finished; 1 the run failed or a thread broke; 2 wrong usage or input;\n"
      "4 interrupted by SIGINT, SIGTERM or SIGUSR1, with what was computed on disk.");
  command->callback([arguments, &code] { code = run(*arguments); });
}

}  // namespace retiarius::program

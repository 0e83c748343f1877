// retiarius converge MISSION: which results hold when step and mesh are refined.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/converge_text.hpp"
#include "program/interruption.hpp"
#include "program/output_guard.hpp"
#include "program/progress.hpp"
#include "program/start_state.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/output_folder.hpp"
#include "retiarius/study/converge.hpp"
#include "retiarius/study/converge_html.hpp"
#include "retiarius/study/converge_json.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct ConvergeArguments {
  MissionArguments mission;
  ComputingArguments computing;
  std::string out, vary = "both";
  int levels = 3;
  double tolerance = 0.02;
};

fs::path output_folder(const ConvergeArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  return fs::path("out") / (fs::path(arguments.mission.file).stem().string() + "-converge");
}

// Shows every run on the status line; where there is none, says that it begins.
class Watch {
 public:
  explicit Watch(const Plan& plan) : plan_(plan) {}

  Observer* at(std::size_t level) {
    if (!status_possible()) {
      print(fmt::format("running {}\n", plan_.levels[level].name));
      flush_output();
      return nullptr;
    }
    progress_ = std::make_unique<Progress>();
    return progress_.get();
  }

 private:
  const Plan& plan_;
  std::unique_ptr<Progress> progress_;
};

ExitCode exit_code(const Study& study) {
  if (study.interrupted) return kInterrupted;
  for (const SeriesResult& series : study.series)
    if (series.count(Verdict::unknown) < series.trends.size()) return kOk;
  return kFailed;  // no two levels to compare
}

ExitCode converge(const ConvergeArguments& arguments) {
  make_write_failures_errors();
  arguments.computing.apply();
  const Mission mission = arguments.mission.read();
  const Vary vary = arguments.vary == "step"   ? Vary::step
                    : arguments.vary == "mesh" ? Vary::mesh
                                               : Vary::both;
  const Plan plan = plan_levels(mission, arguments.levels, vary);
  for (const Level& level : plan.levels) check_memory(estimate(level.mission));
  ConvergeOptions options;
  options.tolerance = arguments.tolerance;
  options.net_state = net_state(mission);
  options.stop = &catch_interruptions();
  RunOptions check;
  check.net_state = options.net_state;
  check_run(mission, MissionModel(mission), check);
  const fs::path out = output_folder(arguments);
  OutputGuard guard(out);
  prepare_output_folder(out);
  guard.keep();

  print(plan_text(plan) + "\n");
  flush_output();
  Watch watch(plan);
  options.watch = [&](std::size_t level) { return watch.at(level); };
  const Study study = retiarius::converge(plan, options);
  show_status("");
  for (std::size_t k = 0; k < study.levels.size(); ++k)
    print(level_text(plan.levels[k], study.levels[k]));
  print(study_text(study));
  write_atomically(out / "converge.json", converge_json(study));
  write_atomically(out / "converge.html", converge_html(study));
  print(fmt::format("\nreport: {}\n", (out / "converge.html").string()));
  return exit_code(study);
}

}  // namespace

void add_converge_command(CLI::App& app, ExitCode& code) {
  CLI::App* command =
      app.add_subcommand("converge", "Refine step and mesh; tell which results hold");
  auto arguments = std::make_shared<ConvergeArguments>();
  arguments->mission.add_to(*command);
  command
      ->add_option("--out", arguments->out,
                   "Folder for the results, new or empty; default out/<mission>-converge")
      ->type_name("DIR");
  command
      ->add_option(
          "--levels", arguments->levels,
          "Runs along step and along mesh, each twice as fine as the one before; default 3")
      ->type_name("N")
      ->check(quiet(CLI::Range(2, 10)));
  command->add_option("--vary", arguments->vary, "What is refined (default: both)")
      ->type_name("step|mesh|both")
      ->check(quiet(CLI::IsMember({"step", "mesh", "both"})));
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "A result holds when the last refinement changes it by no more; default 0.02")
      ->type_name("SHARE")
      ->check(quiet(CLI::PositiveNumber));
  arguments->computing.add_to(*command);
  command->footer(
      "Exit codes: 0 the levels could be compared, whatever the verdicts; 1 fewer than two came "
      "to\n"
      "their end; 2 wrong usage or input; 4 interrupted, with what was computed on disk.");
  command->callback([arguments, &code] { code = converge(*arguments); });
}

}  // namespace retiarius::program

// retiarius campaign replay: one run again, with everything that a run leaves behind; and the
// worker, which other commands start.
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/campaign_arguments.hpp"
#include "program/console.hpp"
#include "program/interruption.hpp"
#include "program/output_guard.hpp"
#include "program/progress.hpp"
#include "retiarius/base/build_info.hpp"
#include "retiarius/base/instruction_set.hpp"
#include "retiarius/base/parallel.hpp"
#include "retiarius/campaign/execute.hpp"
#include "retiarius/campaign/shard.hpp"
#include "retiarius/campaign/worker.hpp"
#include "retiarius/mission/writer.hpp"
#include "retiarius/record/output_folder.hpp"
#include "retiarius/report/run_recorders.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct ReplayArguments {
  CampaignArguments campaign;
  std::int64_t id = 0;
  std::string into;
  int threads = 0;
};

// Says whether the run came out as it is on record; kFailed where it did not.
ExitCode compare(const Campaign& campaign, const fs::path& folder, const RunRecord& again) {
  const std::optional<RunRecord> before = find_record(folder, campaign, again.id);
  if (!before) {
    print("this run is not on record\n");
    return kOk;
  }
  if (before->outcome == "timeout" || before->outcome == "killed") {
    print(fmt::format("on record as {}: {}\n", before->outcome, before->reason));
    return kOk;
  }
  const std::vector<std::string> was = content_lines(*before), is = content_lines(again);
  if (was == is) {
    print("equal to what is on record, bit for bit\n");
    return kOk;
  }
  for (std::size_t i = 0; i < std::max(was.size(), is.size()); ++i) {
    const std::string a = i < was.size() ? was[i] : "nothing",
                      b = i < is.size() ? is[i] : "nothing";
    if (a == b) continue;
    tell_error(fmt::format("run {} differs from its record: was {}, is {}", again.id, a, b));
    break;
  }
  return kFailed;
}

ExitCode replay(const ReplayArguments& arguments) {
  make_write_failures_errors();
  const Campaign campaign(arguments.campaign.file);
  ComputingArguments computing;
  computing.threads = arguments.threads;
  computing.kernels = campaign.spec().kernels;
  computing.apply();
  const fs::path folder = arguments.campaign.folder();
  const fs::path out = arguments.into.empty() ? folder / "replays" / fmt::format("{}", arguments.id)
                                              : fs::path(arguments.into);
  campaign.plan().run(arguments.id);  // throws where there is no such run
  OutputGuard guard(out);
  prepare_output_folder(out);
  std::unique_ptr<FanOut> recorders;
  const auto make_recorder = [&](const Mission& mission) {
    guard.keep();
    RecordOptions options;
    options.resolved = to_toml(mission);
    options.build = build_info();
    options.build.kernels = kernel_name();
    recorders = make_run_recorders(out, options);
    if (status_possible()) recorders->add(std::make_unique<Progress>());
    return recorders.get();
  };
  const std::optional<RunRecord> again =
      execute_run(campaign, arguments.id, make_recorder, &catch_interruptions());
  show_status("");
  if (!again) return kInterrupted;
  print(fmt::format("run {}: {}{}\n", again->id, again->outcome,
                    again->reason.empty() ? "" : ", " + again->reason));
  const ExitCode code = compare(campaign, folder, *again);
  if (recorders) print(fmt::format("report: {}\n", (out / "report.html").string()));
  return code;
}

}  // namespace

void add_campaign_replay(CLI::App& campaign, ExitCode& code) {
  CLI::App* command = campaign.add_subcommand(
      "replay", "Repeat one run alone, bit for bit, with frames and report");
  auto arguments = std::make_shared<ReplayArguments>();
  arguments->campaign.add_to(*command);
  command->add_option("--id", arguments->id, "Of the run")
      ->required()
      ->type_name("K")
      ->check(quiet(CLI::NonNegativeNumber));
  command
      ->add_option("--into", arguments->into,
                   "Folder for this run's results, new or empty; default DIR/replays/K")
      ->type_name("FOLDER");
  command
      ->add_option("--threads", arguments->threads,
                   "Threads to compute with; results do not depend on it (default: all)")
      ->type_name("N")
      ->check(quiet(CLI::Range(1, 4096)));
  command->footer(
      "Exit codes: 0 as on record, or there is none; 1 it came out differently; 2 wrong usage or\n"
      "input; 4 interrupted.");
  command->callback([arguments, &code] { code = replay(*arguments); });
}

void add_campaign_worker(CLI::App& campaign) {
  struct WorkerArguments {
    CampaignArguments campaign;
    std::string shard, engine;
  };
  CLI::App* command = campaign.add_subcommand("worker", "Do the runs that stdin names");
  command->group("");
  auto arguments = std::make_shared<WorkerArguments>();
  arguments->campaign.add_to(*command);
  command->add_option("--shard", arguments->shard)->required();
  command->add_option("--engine", arguments->engine)->required();
  command->callback([arguments] {
    make_write_failures_errors();
    WorkerTask task;
    task.folder = arguments->campaign.folder();
    task.shard = arguments->shard;
    task.engine = arguments->engine;
    work(Campaign(arguments->campaign.file), task);
  });
}

}  // namespace retiarius::program

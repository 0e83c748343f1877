// retiarius campaign status, collect and report.
#include <memory>

#include <fmt/format.h>

#include "program/campaign_arguments.hpp"
#include "program/console.hpp"
#include "program/interruption.hpp"
#include "program/text_table.hpp"
#include "retiarius/campaign/collect.hpp"
#include "retiarius/campaign/report.hpp"
#include "retiarius/campaign/shard.hpp"
#include "retiarius/campaign/statistics.hpp"
#include "retiarius/campaign/stop_rule.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

struct CollectArguments {
  CampaignArguments campaign;
  std::string csv;
};

void require_results(const fs::path& folder) {
  if (!find_shards(folder).empty()) return;
  throw InputError(
      fmt::format("{}: holds no results; `retiarius campaign run` makes them", folder.string()));
}

Collected collect_all(const CollectArguments& arguments) {
  make_write_failures_errors();
  const Campaign campaign(arguments.campaign.file);
  const fs::path folder = arguments.campaign.folder();
  require_results(folder);
  const Collected collected = collect(campaign, folder);
  if (!arguments.csv.empty()) export_rows(folder / "campaign.sqlite", arguments.csv);
  return collected;
}

void collect_command(const CollectArguments& arguments) {
  const Collected collected = collect_all(arguments);
  print(fmt::format("{} of {} runs: {}\n", collected.runs, collected.planned,
                    (arguments.campaign.folder() / "campaign.sqlite").string()));
  if (!arguments.csv.empty()) print(fmt::format("as CSV: {}\n", arguments.csv));
}

void report_command(const CollectArguments& arguments) {
  collect_all(arguments);
  const fs::path folder = arguments.campaign.folder();
  write_campaign_report(read_table(folder / "campaign.sqlite"), folder / "campaign.html");
  print(fmt::format("report: {}\n", (folder / "campaign.html").string()));
}

std::string rate_text(const Progress& progress, std::int64_t end, double confidence) {
  std::int64_t successes = 0, answers = 0;
  for (std::int64_t id = 0; id < end; ++id) {
    const std::uint8_t state = progress.states[static_cast<std::size_t>(id)];
    if (state == kSuccess) ++successes;
    if (state == kSuccess || state == kNoSuccess) ++answers;
  }
  if (answers == 0) return "unknown";
  const Interval interval = wilson_interval(successes, answers, confidence);
  return fmt::format("{:.1f} % ({} of {}), {:g} % interval {:.1f} to {:.1f} %",
                     100.0 * static_cast<double>(successes) / static_cast<double>(answers),
                     successes, answers, 100.0 * confidence, 100.0 * interval.low,
                     100.0 * interval.high);
}

}  // namespace

std::string status_text(const Campaign& campaign, const fs::path& folder) {
  const Progress progress = read_progress(folder, campaign);
  StopRule rule(campaign.spec().stop, campaign.plan().runs());
  rule.update(progress.states);
  TextTable table;
  table.add("runs", fmt::format("{} of {} done", progress.done, campaign.plan().runs()));
  if (rule.stopped()) table.add("stopped", fmt::format("enough is known from {} runs", rule.end()));
  for (const OutcomeCount& count : progress.outcomes)
    table.add(count.outcome, fmt::format("{}", count.runs));
  table.add("success", rate_text(progress, rule.end(), campaign.spec().stop.confidence));
  if (progress.done > 0) {
    table.add("computed", duration(progress.wall_time));
    table.add("a run", duration(progress.wall_time / static_cast<double>(progress.done)));
  }
  return table.text();
}

void add_campaign_status(CLI::App& campaign) {
  CLI::App* command = campaign.add_subcommand("status", "Tell how far a campaign is");
  auto arguments = std::make_shared<CampaignArguments>();
  arguments->add_to(*command);
  command->callback(
      [arguments] { print(status_text(Campaign(arguments->file), arguments->folder())); });
}

void add_campaign_collect(CLI::App& campaign) {
  CLI::App* command =
      campaign.add_subcommand("collect", "Merge what is done into DIR/campaign.sqlite");
  auto arguments = std::make_shared<CollectArguments>();
  arguments->campaign.add_to(*command);
  command->add_option("--csv", arguments->csv, "Write the rows to a CSV file too")
      ->type_name("FILE");
  command->callback([arguments] { collect_command(*arguments); });
}

void add_campaign_report(CLI::App& campaign) {
  CLI::App* command =
      campaign.add_subcommand("report", "Merge what is done and write DIR/campaign.html");
  auto arguments = std::make_shared<CollectArguments>();
  arguments->campaign.add_to(*command);
  command->callback([arguments] { report_command(*arguments); });
}

}  // namespace retiarius::program

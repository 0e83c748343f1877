// retiarius campaign plan: what would be run.
#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "program/arguments.hpp"
#include "program/campaign_arguments.hpp"
#include "program/console.hpp"
#include "program/text_table.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius::program {

namespace {

struct PlanArguments {
  CampaignArguments campaign;
  std::int64_t show = 10;
  std::string csv;
};

void write_csv(const Campaign& campaign, const std::string& file) {
  OutputFile out(file);
  std::string text = fmt::format("id,seed,{}\r\n", fmt::join(campaign.spec().input_names(), ","));
  constexpr std::size_t kPiece = 1u << 20;
  for (std::int64_t id = 0; id < campaign.plan().runs(); ++id) {
    const PlannedRun run = campaign.plan().run(id);
    text += fmt::format("{},{},{}\r\n", id, run.seed, fmt::join(run.inputs, ","));
    if (text.size() < kPiece) continue;
    out.write(text);
    text.clear();
  }
  out.write(text);
  out.sync();
  out.close();
}

void plan(const PlanArguments& arguments) {
  const Campaign campaign(arguments.campaign.file);
  const std::int64_t runs = campaign.plan().runs();
  if (!arguments.csv.empty()) {
    write_csv(campaign, arguments.csv);
    print(fmt::format("plan of {} runs: {}\n", runs, arguments.csv));
    return;
  }
  const Estimate need = estimate(campaign.mission(campaign.plan().run(0)));
  TextTable head;
  if (!campaign.spec().title.empty()) head.add("campaign", campaign.spec().title);
  head.add("mission", campaign.spec().mission_path());
  head.add("runs", fmt::format("{}", runs));
  head.add("each", fmt::format("{:.0f} nodes, {} of memory", need.nodes, byte_count(need.memory)));
  print(head.text() + "\n");
  TextTable rows;
  std::vector<std::string> names = {"id"};
  for (const std::string& name : campaign.spec().input_names()) names.push_back(name);
  rows.add(names);
  for (std::int64_t id = 0; id < std::min(runs, arguments.show); ++id) {
    std::vector<std::string> cells = {fmt::format("{}", id)};
    for (const double value : campaign.plan().run(id).inputs)
      cells.push_back(fmt::format("{:.6g}", value));
    rows.add(cells);
  }
  print(rows.text());
  if (runs > arguments.show) print("  ...\n");
}

}  // namespace

void add_campaign_plan(CLI::App& campaign) {
  CLI::App* command =
      campaign.add_subcommand("plan", "Tell how many runs there are and what they vary");
  auto arguments = std::make_shared<PlanArguments>();
  command->add_option("FILE", arguments->campaign.file, "Campaign file (TOML)")
      ->required()
      ->type_name("");
  command->add_option("--show", arguments->show, "So many runs (default: 10)")
      ->type_name("N")
      ->check(quiet(CLI::NonNegativeNumber));
  command->add_option("--csv", arguments->csv, "Write all runs' inputs to a file instead")
      ->type_name("FILE");
  command->callback([arguments] { plan(*arguments); });
}

}  // namespace retiarius::program

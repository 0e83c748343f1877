// retiarius campaign: many runs of one mission.
#include "program/campaign_arguments.hpp"
#include "program/commands.hpp"

namespace retiarius::program {

void CampaignArguments::add_to(CLI::App& command) {
  command.add_option("FILE", file, "Campaign file (TOML)")->required()->type_name("");
  command.add_option("--out", out, "Folder of the campaign's results; default out/<campaign>")
      ->type_name("DIR");
}

std::filesystem::path CampaignArguments::folder() const {
  namespace fs = std::filesystem;
  if (!out.empty()) return out;
  return fs::path("out") / fs::path(file).stem();
}

void add_campaign_command(CLI::App& app, ExitCode& code) {
  CLI::App* command =
      app.add_subcommand("campaign", "Run a mission many times, with varied inputs");
  command->require_subcommand(1);
  add_campaign_plan(*command);
  add_campaign_run(*command, code);
  add_campaign_status(*command);
  add_campaign_collect(*command);
  add_campaign_report(*command);
  add_campaign_replay(*command, code);
  add_campaign_worker(*command);
  command->footer(
      "A run that diverges, times out or dies is recorded with its reason, and the others go on.\n"
      "Nothing that is done is ever done again: `run` and `resume` go on where they were.");
}

}  // namespace retiarius::program

// What the commands of `retiarius campaign` share.
#pragma once

#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "program/exit_code.hpp"
#include "retiarius/campaign/campaign.hpp"

namespace retiarius::program {

// FILE and --out.
struct CampaignArguments {
  std::string file, out;

  void add_to(CLI::App& command);
  // The campaign's folder of results; default out/<name of the file>.
  std::filesystem::path folder() const;
};

// Each adds one command to `campaign`.
void add_campaign_plan(CLI::App& campaign);
void add_campaign_run(CLI::App& campaign, ExitCode& code);
void add_campaign_status(CLI::App& campaign);
void add_campaign_collect(CLI::App& campaign);
void add_campaign_report(CLI::App& campaign);
void add_campaign_replay(CLI::App& campaign, ExitCode& code);
void add_campaign_worker(CLI::App& campaign);

// How far the campaign is, in aligned columns.
std::string status_text(const Campaign& campaign, const std::filesystem::path& folder);

}  // namespace retiarius::program

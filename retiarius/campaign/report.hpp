// The report of a campaign: one HTML file that opens offline and prints well.
#pragma once

#include <filesystem>
#include <string>

#include "retiarius/campaign/table.hpp"

namespace retiarius {

// The page as text: success rate with its interval and how it came to rest, a success map, the
// distributions, responses, rank correlations, Sobol indices where the design gives them, worst
// cases and how runs ended. A pure function of the table, byte for byte. Throws InputError where a
// row has another number of values than the table has names, or where ids do not ascend.
std::string campaign_html(const CampaignTable& table);

// Writes campaign_html() to the file, replacing it as a whole. Throws RunError where it cannot be
// written.
void write_campaign_report(const CampaignTable& table, const std::filesystem::path& file);

}  // namespace retiarius

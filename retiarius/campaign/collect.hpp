// Merges the shards of a campaign into one database, and reads it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "retiarius/campaign/campaign.hpp"
#include "retiarius/campaign/table.hpp"

namespace retiarius {

struct Collected {
  std::int64_t runs = 0;     // rows
  std::int64_t planned = 0;  // that the campaign would have: of the plan, or to where it stopped
  std::int64_t twice = 0;    // rows that more than one shard had, equal
};

// Writes DIR/campaign.sqlite anew, whatever order the shards are in:
// - table `runs`, by ascending id, what is equal for every engine: id; an input each as in_NAME;
//   outcome, reason, success; a measure each; missing, seed, versions, command, kept;
// - table `timings`: id, host, engine, started, wall_time (s), attempts;
// - table `campaign`: key, value: title, design, identity, planned runs, the campaign file.
// Rows after the end of the stop rule are left out. Throws InputError where two shards differ in
// what they say of a run, naming its id, and where a shard is of another campaign; RunError where
// it cannot be written.
Collected collect(const Campaign& campaign, const std::filesystem::path& folder);

// The collected database as the table that statistics and report read.
CampaignTable read_table(const std::filesystem::path& database);

// Table `runs` as CSV (RFC 4180) with a header; absent values are empty, numbers read back to the
// same bits.
void export_rows(const std::filesystem::path& database, const std::filesystem::path& csv);

// What a row of the collected database says of a run, for comparisons: every column of `runs` as
// text; empty where there is no such run.
std::string collected_row(const std::filesystem::path& database, std::int64_t id);

}  // namespace retiarius

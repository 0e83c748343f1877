// The schema of the campaign file: every table and key, once, as retiarius/mission/key.hpp says.
#pragma once

#include <string>

#include "retiarius/campaign/spec.hpp"
#include "retiarius/mission/key.hpp"

namespace retiarius {

inline constexpr int kCampaignFormat = 1;  // of the campaign file, key `format`

const Table<CampaignSpec>& campaign_table();
const Table<PlanSpec>& plan_table();
const Table<VariableSpec>& variable_table();
const Table<GroupSpec>& group_table();
const Table<KeepSpec>& keep_table();
const Table<LimitSpec>& limit_table();
const Table<StopSpec>& stop_table();

// docs/campaign-file.md, from the schema.
std::string campaign_file_markdown();

}  // namespace retiarius

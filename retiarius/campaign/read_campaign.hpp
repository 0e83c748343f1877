// From a campaign file to a CampaignSpec: read, defaulted, checked.
#pragma once

#include <string>

#include "retiarius/campaign/spec.hpp"

namespace retiarius {

// Throws InputError with file, line and column, the key, its value and what is allowed. The mission
// is not read yet.
CampaignSpec read_campaign(const std::string& path);

// The same from text; `name` stands for the file in messages, relative paths start from `folder`.
CampaignSpec parse_campaign(const std::string& text, const std::string& name = "campaign",
                            const std::string& folder = ".");

}  // namespace retiarius

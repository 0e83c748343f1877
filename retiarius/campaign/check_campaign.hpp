// What no single key of a campaign can tell: values that must fit each other.
#pragma once

#include "retiarius/campaign/spec.hpp"
#include "retiarius/mission/places.hpp"

namespace retiarius {

// Throws InputError at the place of the offending key.
void check_campaign(const CampaignSpec& campaign, const Places& places);

}  // namespace retiarius

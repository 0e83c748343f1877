// Any text as a campaign file; where it reads, the inputs of its first runs must come out too.
#include <algorithm>

#include "fuzz/target.hpp"
#include "retiarius/campaign/plan.hpp"
#include "retiarius/campaign/read_campaign.hpp"

RETIARIUS_FUZZ_TARGET(bytes) {
  using namespace retiarius;
  fuzz::accept_or_refuse([&] {
    const CampaignSpec campaign = parse_campaign(std::string(bytes), "c.toml", "/nonexistent");
    const CampaignPlan plan(campaign);
    fuzz::require(plan.runs() > 0, "a campaign without runs");
    for (std::int64_t id : {std::int64_t{0}, std::min<std::int64_t>(7, plan.runs() - 1),
                            plan.runs() - 1}) {
      const PlannedRun run = plan.run(id);
      fuzz::require(run.inputs == plan.run(id).inputs, "a run's inputs change");
    }
  });
}

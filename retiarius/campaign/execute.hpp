// Does one run of a campaign.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "retiarius/campaign/campaign.hpp"
#include "retiarius/campaign/run_record.hpp"
#include "retiarius/mission/observer.hpp"

namespace retiarius {

// Everything of a run's record that is known before it runs.
RunRecord planned_record(const Campaign& campaign, std::int64_t id);

// Makes the observer that writes the results of a run; may return null.
using RecorderMaker = std::function<Observer*(const Mission&)>;

// Runs it. Whatever the run itself does wrong is in the record. None where `stop` was set from
// outside before its end. What the recorder throws goes on: a full disk is no matter of the run.
std::optional<RunRecord> execute_run(const Campaign& campaign, std::int64_t id,
                                     const RecorderMaker& make_recorder,
                                     const std::atomic<bool>* stop = nullptr);

// The same, keeping in `folder`/runs/ID what the campaign says. Throws RunError where that cannot
// be written.
std::optional<RunRecord> execute_and_keep(const Campaign& campaign, std::int64_t id,
                                          const std::filesystem::path& folder,
                                          const std::atomic<bool>* stop = nullptr);

// The measures of a run as its record has them: wall_time left out, success apart, what is not
// finite made absent with its reason. In place.
void clean_measures(RunRecord& record);

// Name of this machine.
std::string host_name();

// Now, UTC, ISO 8601.
std::string utc_now();

// What a record of a run says that took too long.
void set_timeout(RunRecord& record, const LimitSpec& limits);

}  // namespace retiarius

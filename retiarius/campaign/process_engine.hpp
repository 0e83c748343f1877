// The engine of one machine: worker processes that a coordinator tells which run is next.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "retiarius/campaign/campaign.hpp"
#include "retiarius/campaign/run_queue.hpp"

namespace retiarius {

struct EngineSettings {
  std::string program;           // this one, that workers execute
  std::filesystem::path folder;  // of the results
  int jobs = 1;                  // worker processes
  std::int64_t first = 0;        // ids from first to before last
  std::int64_t last = 0;
  std::string engine = "processes";         // as records name it
  const std::atomic<bool>* stop = nullptr;  // set from outside to end soon
  std::function<void(RunQueue&)> progress;  // told when runs end, and now and then; may be empty
};

// True where everything is done; false where it was stopped. Throws RunError where results cannot
// be written, and InputError where the folder holds another campaign's; what is done stays.
bool run_processes(const Campaign& campaign, const EngineSettings& settings);

// Makes the folder, where it is missing, and its shards folder. Throws InputError.
void prepare_campaign_folder(const std::filesystem::path& folder);

// The name of a shard that no other process writes now: of this machine, process and slot.
std::string shard_name(int slot);

// Keeps a second coordinator on this machine out of the folder while it lives. Waits up to a second
// for one that is about to leave, then throws InputError that names the process that is at work.
class CampaignLock {
 public:
  explicit CampaignLock(const std::filesystem::path& folder);
  ~CampaignLock();
  CampaignLock(const CampaignLock&) = delete;
  CampaignLock& operator=(const CampaignLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace retiarius

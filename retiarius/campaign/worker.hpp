// The process that does runs, one after another, as it is told.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "retiarius/campaign/campaign.hpp"

namespace retiarius {

struct WorkerTask {
  std::filesystem::path folder;  // of the campaign's results
  std::string shard;             // name of its shard, without folder and ending
  std::string engine;            // as records name it
  int orders = 0;                // descriptor that it reads ids from, a line each
  int answers = 1;               // descriptor that it writes to
};

// Says "ready IDENTITY", then for each id, once its row is on the device, "done ID STATE", STATE
// being a RunState; ends well when there are no more orders. "failed TEXT" tells why it ends
// otherwise: results cannot be written. Keeps to one thread.
void work(const Campaign& campaign, const WorkerTask& task);

}  // namespace retiarius

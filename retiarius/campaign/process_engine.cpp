#include "retiarius/campaign/process_engine.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <unistd.h>

#include "retiarius/campaign/execute.hpp"
#include "retiarius/campaign/worker_process.hpp"

namespace retiarius {

namespace fs = std::filesystem;

namespace {

constexpr int kLongestWait = 250;  // ms

void wait_for_answers(const std::vector<std::unique_ptr<WorkerProcess>>& workers) {
  std::vector<pollfd> watched;
  for (const auto& worker : workers)
    if (worker->descriptor() >= 0) watched.push_back({worker->descriptor(), POLLIN, 0});
  ::poll(watched.data(), watched.size(), kLongestWait);
}

// A coordinator that was killed while it started a worker leaves a child that holds the lock until
// it has become the worker's program or has died too: that is worth a second's patience.
bool take_lock(int file) {
  constexpr int kTrials = 20;
  for (int trial = 0; trial < kTrials; ++trial) {
    if (::flock(file, LOCK_EX | LOCK_NB) == 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

bool is_part(const Campaign& campaign, const EngineSettings& settings) {
  return settings.first > 0 || settings.last < campaign.plan().runs();
}

// What is known when the engine starts; a rule of when to stop looks at all runs.
std::vector<std::uint8_t> known_states(const Campaign& campaign, const EngineSettings& settings) {
  if (campaign.spec().stop.width > 0.0) return read_progress(settings.folder, campaign).states;
  return read_progress(settings.folder, campaign, settings.first, settings.last).states;
}

std::vector<std::unique_ptr<WorkerProcess>> make_workers(const Campaign& campaign,
                                                         const EngineSettings& settings) {
  std::vector<std::unique_ptr<WorkerProcess>> workers;
  const std::string ids =
      is_part(campaign, settings) ? ids_in_name(settings.first, settings.last) : "";
  workers.reserve(static_cast<std::size_t>(settings.jobs));
  for (int slot = 0; slot < settings.jobs; ++slot)
    workers.push_back(std::make_unique<WorkerProcess>(
        campaign, WorkerSettings{settings.program, campaign.spec().file, settings.folder,
                                 ids + shard_name(slot), settings.engine}));
  return workers;
}

}  // namespace

bool run_processes(const Campaign& campaign, const EngineSettings& settings) {
  RunQueue queue(campaign.spec().stop, known_states(campaign, settings), settings.first,
                 settings.last);
  const auto workers = make_workers(campaign, settings);
  if (settings.progress) settings.progress(queue);
  while (!queue.finished()) {
    if (settings.stop && *settings.stop) return false;
    for (const auto& worker : workers) {
      if (worker->busy()) continue;
      if (const auto id = queue.next()) worker->begin(*id);
    }
    wait_for_answers(workers);
    for (const auto& worker : workers)
      if (const auto finished = worker->advance()) queue.done(finished->id, finished->state);
    if (settings.progress) settings.progress(queue);
  }
  return true;
}

void prepare_campaign_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder / "shards", error);
  if (error)
    throw InputError(fmt::format("{}: cannot be made: {}", folder.string(), error.message()));
}

std::string shard_name(int slot) { return fmt::format("{}-{}-{}", host_name(), ::getpid(), slot); }

CampaignLock::CampaignLock(const fs::path& folder) {
  const fs::path path = folder / "lock";
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw InputError(fmt::format("{}: {}", path.string(), std::strerror(errno)));
  if (take_lock(file_)) {
    const std::string text = fmt::format("{}\n", ::getpid());
    if (::ftruncate(file_, 0) == 0) [[maybe_unused]]
      const auto written = ::pwrite(file_, text.data(), text.size(), 0);
    return;
  }
  char bytes[32] = {};
  [[maybe_unused]] const auto count = ::pread(file_, bytes, sizeof bytes - 1, 0);
  ::close(file_);
  throw InputError(fmt::format("{}: process {} is at work on this campaign; wait for it, or end it",
                               folder.string(), std::strtol(bytes, nullptr, 10)));
}

CampaignLock::~CampaignLock() { ::close(file_); }

}  // namespace retiarius

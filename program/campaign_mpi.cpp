#include "program/campaign_mpi.hpp"

#include <cstdlib>

#include "retiarius/base/error.hpp"

#ifdef RETIARIUS_WITH_MPI
#include <array>
#include <deque>

#include <fmt/format.h>
#include <mpi.h>
#include <poll.h>

#include "program/failure.hpp"
#include "retiarius/campaign/worker_process.hpp"
#endif

namespace retiarius::program {

bool under_mpi() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"})
    if (std::getenv(name) != nullptr) return true;
  return false;
}

#ifndef RETIARIUS_WITH_MPI

bool mpi_built_in() { return false; }

std::string mpi_text() { return "not built in"; }

ExitCode run_mpi(const Campaign&, const EngineSettings&, const std::function<ExitCode(bool)>&) {
  throw InputError(
      "this program was built without MPI (CMake option RETIARIUS_MPI); use --engine processes, or "
      "build it where MPI is installed");
}

#else

namespace {

constexpr int kTag = 1;
constexpr int kWait = 1;  // ms between looks for messages

// From a rank to rank 0: it has nothing to do, after having done a run or not; or it leaves.
enum Kind : std::int64_t { kIdle, kDone, kLeaving };
constexpr std::int64_t kNoMore = -1;  // from rank 0 to a rank: leave

using Message = std::array<std::int64_t, 3>;  // kind, id, state

void send(int rank, const Message& message) {
  MPI_Send(message.data(), 3, MPI_INT64_T, rank, kTag, MPI_COMM_WORLD);
}

// A message and its sender, if there is one; does not wait, for waiting in MPI keeps a core busy.
std::optional<std::pair<int, Message> > receive() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return std::nullopt;
  Message message{};
  MPI_Recv(message.data(), 3, MPI_INT64_T, status.MPI_SOURCE, kTag, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return std::pair(status.MPI_SOURCE, message);
}

void wait(const WorkerProcess& worker) {
  pollfd watched{worker.descriptor(), POLLIN, 0};  // a negative one is left out
  ::poll(&watched, 1, kWait);
}

WorkerSettings worker_settings(const Campaign& campaign, const EngineSettings& settings, int rank) {
  return {settings.program, campaign.spec().file, settings.folder, shard_name(rank),
          settings.engine};
}

bool stopped(const EngineSettings& settings) { return settings.stop && *settings.stop; }

// Rank 0: hands out ids and does runs too.
class Coordinator {
 public:
  Coordinator(const Campaign& campaign, const EngineSettings& settings, int ranks)
      : settings_(settings),
        queue_(campaign.spec().stop, read_progress(settings.folder, campaign).states,
               settings.first, settings.last),
        worker_(campaign, worker_settings(campaign, settings, 0)),
        others_(ranks - 1) {}

  bool run() {
    while (others_ > 0 || !(queue_.finished() || stopped(settings_))) {
      hear();
      if (const auto finished = worker_.advance()) queue_.done(finished->id, finished->state);
      if (!worker_.busy() && !stopped(settings_))
        if (const auto id = queue_.next()) worker_.begin(*id);
      answer();
      if (settings_.progress) settings_.progress(queue_);
      wait(worker_);
    }
    return queue_.finished();
  }

 private:
  void hear() {
    while (const auto heard = receive()) {
      const auto& [rank, message] = *heard;
      if (message[0] == kDone) queue_.done(message[1], static_cast<RunState>(message[2]));
      if (message[0] == kLeaving) {
        --others_;
      } else {
        idle_.push_back(rank);
      }
    }
  }

  void answer() {
    std::deque<int> still;
    for (const int rank : idle_) {
      const bool over = queue_.finished() || stopped(settings_);
      const auto id = over ? std::optional<std::int64_t>(kNoMore) : queue_.next();
      if (!id) {
        still.push_back(rank);
        continue;
      }
      send(rank, {*id, 0, 0});
      if (*id == kNoMore) --others_;
    }
    idle_ = still;
  }

  const EngineSettings& settings_;
  RunQueue queue_;
  WorkerProcess worker_;
  int others_;
  std::deque<int> idle_;
};

// Any other rank.
void follow(const Campaign& campaign, const EngineSettings& settings, int rank) {
  WorkerProcess worker(campaign, worker_settings(campaign, settings, rank));
  send(0, {kIdle, 0, 0});
  for (bool waiting = true;;) {
    if (!waiting && stopped(settings)) {
      send(0, {kLeaving, 0, 0});
      return;
    }
    if (const auto heard = receive()) {
      const std::int64_t id = heard->second[0];
      if (id == kNoMore) return;
      worker.begin(id);
      waiting = false;
    }
    if (const auto finished = worker.advance()) {
      send(0, {kDone, finished->id, finished->state});
      waiting = true;
    }
    wait(worker);
  }
}

}  // namespace

bool mpi_built_in() { return true; }

std::string mpi_text() {
  std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
  int length = 0;
  MPI_Get_library_version(text.data(), &length);
  const std::string all(text.data(), static_cast<std::size_t>(length));
  return all.substr(0, all.find(','));
}

ExitCode run_mpi(const Campaign& campaign, const EngineSettings& settings,
                 const std::function<ExitCode(bool)>& finish) {
  MPI_Init(nullptr, nullptr);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  ExitCode code = kOk;
  try {
    if (rank == 0) {
      const CampaignLock lock(settings.folder);
      code = finish(Coordinator(campaign, settings, ranks).run());
    } else {
      follow(campaign, settings, rank);
    }
  } catch (...) {
    // Nobody else can go on; what is done is on the device.
    MPI_Abort(MPI_COMM_WORLD, tell_failure(std::current_exception()));
  }
  MPI_Finalize();
  return code;
}

#endif

}  // namespace retiarius::program

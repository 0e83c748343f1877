// A worker as its coordinator sees it: a child process that does one run at a time, and that may
// die.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "retiarius/campaign/campaign.hpp"
#include "retiarius/campaign/shard.hpp"

namespace retiarius {

struct WorkerSettings {
  std::string program;           // to execute
  std::string campaign;          // file
  std::filesystem::path folder;  // of the campaign's results
  std::string shard;             // name of its shard
  std::string engine;
};

class WorkerProcess {
 public:
  struct Finished {
    std::int64_t id = 0;
    RunState state = kNotDone;
  };

  // Nothing is started yet.
  WorkerProcess(const Campaign& campaign, WorkerSettings settings);
  ~WorkerProcess();  // ends the child at once; the run under way is lost
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  // Begins a run; only when not busy(). Throws RunError where no process can be started.
  void begin(std::int64_t id);
  bool busy() const { return id_.has_value(); }

  // Readable when there is something for advance(); -1 without child.
  int descriptor() const { return answers_; }

  // What has come about since: a run that is on record now. A child that died is replaced, and its
  // run is begun again or recorded as killed; one that exceeds the wall clock without ending by
  // itself is ended. Throws RunError where the child cannot work: a full disk, another campaign.
  std::optional<Finished> advance();

 private:
  using Clock = std::chrono::steady_clock;

  void start();
  void send();
  void stop();
  std::optional<Finished> take(const std::string& line);
  std::optional<Finished> take_death();
  bool read_answers();
  bool overdue() const;
  Finished record_end(const std::string& outcome, const std::string& reason);
  std::filesystem::path shard_path() const;

  const Campaign* campaign_;
  WorkerSettings settings_;
  pid_t process_ = -1;
  int orders_ = -1, answers_ = -1;
  std::string text_;
  bool ready_ = false;
  std::string failure_;
  std::optional<std::int64_t> id_;
  std::int64_t attempt_ = 0;
  Clock::time_point begun_;
};

}  // namespace retiarius

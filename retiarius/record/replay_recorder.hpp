// replay.bin: a compact recording of a run for looking at it, written while the run goes on.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "retiarius/mission/observer.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/record/replay_codec.hpp"

namespace retiarius {

// One chunk a frame (replay_chunk.hpp tells the layout), handed to the operating system before the
// run goes on: a process that is killed at any instant costs at most the frame being written.
// Positions are rounded with an error of at most kReplayError sizes of the net along each axis,
// tensions to 0.4 %, strains and speeds to 0.8 %, curvatures to 1.6 %. Throws RunError.
class ReplayRecorder : public Observer {
 public:
  // `version` is the program's.
  ReplayRecorder(const std::filesystem::path& folder, std::string version);

  void begin(const RunModel& model) override;
  void frame(const Frame& frame) override;
  void save(const Checkpoint& saved, bool durable) override;
  void resumed() override;
  void end(const RunReport& report) override;

 private:
  std::filesystem::path path_;
  std::string version_;
  std::unique_ptr<OutputFile> file_;
  std::unique_ptr<ReplayCodec> codec_;
};

// The JSON text of the last chunk: outcome, reason, and phases with name, kind, start and end (s).
std::string replay_end(const RunReport& report);

}  // namespace retiarius

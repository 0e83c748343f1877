#include "retiarius/record/replay_recorder.hpp"

#include <nlohmann/json.hpp>

#include "retiarius/record/replay_chunk.hpp"
#include "retiarius/record/replay_header.hpp"
#include "retiarius/record/summary_json.hpp"

namespace retiarius {

namespace {

using Json = nlohmann::ordered_json;

ReplayFrame replay_frame(const Frame& frame) {
  const State& s = *frame.state;
  ReplayFrame replay;
  replay.time = s.time;
  replay.phase = frame.phase;
  replay.x = s.x;
  replay.tension = frame.tension;
  replay.strain = frame.strain;
  replay.curvature = frame.curvature;
  replay.speed.reserve(s.v.size());
  for (const Vec3& v : s.v) replay.speed.push_back(v.norm());
  replay.touch.assign(s.x.size(), 0);
  for (const Touch& touch : s.touches)
    replay.touch.at(static_cast<std::size_t>(touch.node)) = touch.sticks ? 2 : 1;
  replay.bodies = s.bodies;
  return replay;
}

}  // namespace

std::string replay_end(const RunReport& report) {
  Json end;
  end["outcome"] = to_string(report.outcome);
  end["reason"] = report.reason;
  end["phases"] = Json::array();
  for (const PhaseReport& phase : report.phases)
    end["phases"].push_back({{"name", phase.name},
                             {"kind", phase_kind_name(phase.kind)},
                             {"start", phase.start},
                             {"end", phase.end}});
  return end.dump(-1, ' ', false, Json::error_handler_t::replace);
}

ReplayRecorder::ReplayRecorder(const std::filesystem::path& folder, std::string version)
    : path_(folder / "replay.bin"), version_(std::move(version)) {}

void ReplayRecorder::begin(const RunModel& model) {
  file_ = std::make_unique<OutputFile>(model.resumed ? new_name(path_) : path_);
  codec_ = std::make_unique<ReplayCodec>(replay_shape(model), replay_scales(model));
  file_->write(replay_preamble() + replay_chunk("HEAD", replay_header(model, version_)));
}

void ReplayRecorder::frame(const Frame& frame) {
  if (!file_) return;
  // A write that fails leaves a torn chunk, after which nothing may follow.
  std::unique_ptr<OutputFile> file = std::move(file_);
  file->write(replay_chunk("FRAM", codec_->encode(replay_frame(frame))));
  file_ = std::move(file);
}

void ReplayRecorder::save(const Checkpoint&, bool durable) {
  if (durable && file_) file_->sync();
}

void ReplayRecorder::resumed() {
  if (file_) file_->rename_to(path_);
}

void ReplayRecorder::end(const RunReport& report) {
  if (!file_) return;
  file_->write(replay_chunk("ENDS", replay_end(report)));
  file_->close();
  file_.reset();
}

}  // namespace retiarius

#include "retiarius/record/recorders.hpp"

#include <exception>

#include "retiarius/record/file.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/record/output_folder.hpp"
#include "retiarius/record/replay_recorder.hpp"
#include "retiarius/record/run_h5.hpp"
#include "retiarius/record/summary_json.hpp"
#include "retiarius/record/vtk_frames.hpp"

namespace retiarius {

template <class Call>
void FanOut::each(bool broken_too, Call&& call) {
  std::exception_ptr first;
  for (Part& part : parts_) {
    if (part.broken && !broken_too) continue;
    try {
      call(*part.observer);
    } catch (...) {
      part.broken = true;
      if (!first) first = std::current_exception();
    }
  }
  if (!first || failed_) return;
  failed_ = true;
  std::rethrow_exception(first);
}

void FanOut::begin(const RunModel& model) {
  each(false, [&](Observer& observer) { observer.begin(model); });
}

void FanOut::history(const HistoryRow& row) {
  each(false, [&](Observer& observer) { observer.history(row); });
}

void FanOut::frame(const Frame& frame) {
  each(false, [&](Observer& observer) { observer.frame(frame); });
}

void FanOut::save(const Checkpoint& saved, bool durable) {
  each(false, [&](Observer& observer) { observer.save(saved, durable); });
}

void FanOut::resumed() {
  each(false, [&](Observer& observer) { observer.resumed(); });
}

void FanOut::progress(const State& state, Index phase, double phase_fraction) {
  each(false, [&](Observer& observer) { observer.progress(state, phase, phase_fraction); });
}

void FanOut::end(const RunReport& report) {
  each(true, [&](Observer& observer) { observer.end(report); });
}

RunIdentity run_identity(const RecordOptions& options) {
  return {options.build.version, options.build.revision, options.build.kernels,
          fnv1a(options.resolved), 0};
}

std::unique_ptr<FanOut> make_recorders(const std::filesystem::path& folder,
                                       const RecordOptions& options) {
  if (!options.resume) {
    prepare_output_folder(folder, options.overwrite);
    write_atomically(folder / "resolved.toml", options.resolved);
    if (!options.mission.empty()) write_atomically(folder / "mission.toml", options.mission);
  }
  auto all = std::make_unique<FanOut>();
  all->add(std::make_unique<HistoryCsv>(folder));
  all->add(std::make_unique<RunH5>(folder, options.resolved, options.build.version));
  all->add(std::make_unique<ReplayRecorder>(folder, options.build.version));
  if (options.vtk) all->add(std::make_unique<VtkFrames>(folder));
  // After all others: what it counts has reached its file.
  all->add(std::make_unique<CheckpointFile>(folder, run_identity(options)));
  all->add(std::make_unique<SummaryJson>(folder, options.build));
  return all;
}

}  // namespace retiarius

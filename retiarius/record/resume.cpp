#include "retiarius/record/resume.hpp"

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/history_csv.hpp"
#include "retiarius/record/run_file.hpp"
#include "retiarius/record/run_h5.hpp"

namespace retiarius {

namespace {

namespace fs = std::filesystem;

SavedRun usable(const fs::path& folder, const fs::path& checkpoint) {
  SavedRun saved = read_saved_run(checkpoint);
  const Checkpoint& c = saved.checkpoint;
  if (c.ended) return saved;
  if (c.progress.empty())
    throw InputError(fmt::format("{} holds a state alone, not a run", checkpoint.string()));
  mend_run_file(folder / "run.h5");
  const RunFile file(folder / "run.h5");
  const std::size_t rows = file.history("time").size(), frames = file.frame_count();
  if (c.rows < 0 || c.frames < 0 || rows < static_cast<std::uint64_t>(c.rows) ||
      frames < static_cast<std::uint64_t>(c.frames))
    throw InputError(fmt::format("{} counts {} rows and {} frames, {} has {} and {}",
                                 checkpoint.string(), c.rows, c.frames,
                                 (folder / "run.h5").string(), rows, frames));
  return saved;
}

void tell_frame(const FrameData& data, Observer& observer) {
  State state;
  state.time = data.time;
  state.x = data.x;
  state.v = data.v;
  state.bodies = data.bodies;
  for (std::size_t k = 0; k < data.contact.size(); ++k) {
    if (data.contact[k] == 0) continue;
    Touch touch;
    touch.node = static_cast<Index>(k);
    touch.sticks = data.contact[k] == 2;
    state.touches.push_back(touch);
  }
  observer.frame({data.phase, &state, data.tension, data.strain, data.curvature, data.contacts});
}

void retell(const fs::path& path, const Checkpoint& upto, const Mission& mission,
            Observer& observer) {
  const RunFile file(path);
  std::vector<std::vector<double>> columns;
  for (const std::string& name : file.history_names()) columns.push_back(file.history(name));
  const std::vector<double> times = file.frame_times();
  const auto rows = static_cast<std::size_t>(upto.rows);
  const auto frames = static_cast<std::size_t>(upto.frames);
  std::size_t frame = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    std::vector<double> values;
    for (const std::vector<double>& column : columns) values.push_back(column.at(k));
    const HistoryRow row = history_row(values, mission);
    observer.history(row);
    for (; frame < frames && times[frame] <= row.time; ++frame)
      tell_frame(file.frame(frame), observer);
  }
  for (; frame < frames; ++frame) tell_frame(file.frame(frame), observer);
}

}  // namespace

ResumableRun find_resumable(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw InputError(
        fmt::format("cannot resume {}: it is not the folder of a run", folder.string()));
  const fs::path newest = folder / "checkpoint", previous = previous_checkpoint(newest);
  if (!fs::exists(newest, ignored) && !fs::exists(previous, ignored))
    throw InputError(fmt::format("cannot resume {}: it has no checkpoint", folder.string()));
  std::string complaint;
  try {
    return {usable(folder, newest), newest, ""};
  } catch (const InputError& error) {
    complaint = error.what();
  }
  try {
    return {usable(folder, previous), previous, complaint};
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("cannot resume {}: {}; {}", folder.string(), complaint, error.what()));
  }
}

void check_identity(const RunIdentity& saved, const RunIdentity& now) {
  const auto refuse = [](const std::string& cause) {
    throw InputError(fmt::format("cannot resume the run: {}", cause));
  };
  if (saved.version != now.version || saved.revision != now.revision)
    refuse(
        fmt::format("it was begun by retiarius {} ({}), this is {} ({}), which may compute other "
                    "digits; go on with that one, or begin a new run with --start",
                    saved.version, saved.revision, now.version, now.revision));
  if (saved.kernels != now.kernels)
    refuse(
        fmt::format("it was begun with the kernels {}, these are {}", saved.kernels, now.kernels));
  if (saved.mission != now.mission)
    refuse("its resolved.toml is not the mission that the checkpoint belongs to");
  if (saved.model != 0 && now.model != 0 && saved.model != now.model)
    refuse(
        "the mission builds another net or other bodies than it did: a file that it names has "
        "changed");
}

Resumption resumption(const fs::path& folder, const ResumableRun& run) {
  Resumption result;
  result.checkpoint = run.saved.checkpoint;
  result.retell = [path = folder / "run.h5", upto = run.saved.checkpoint](const Mission& mission,
                                                                          Observer& observer) {
    retell(path, upto, mission, observer);
  };
  return result;
}

}  // namespace retiarius

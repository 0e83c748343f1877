// The observers of one run, combined into one.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/mission/observer.hpp"
#include "retiarius/record/build_info.hpp"

namespace retiarius {

// Passes everything on to several observers in order. In end() all are told, even when some throw,
// so that a full disk for one does not cost the summary; then the first exception goes on.
class FanOut : public Observer {
 public:
  void add(std::unique_ptr<Observer> observer) { observers_.push_back(std::move(observer)); }

  void begin(const RunModel& model) override;
  void history(const HistoryRow& row) override;
  void frame(const Frame& frame) override;
  void checkpoint(const State& state) override;
  void progress(const State& state, Index phase, double phase_fraction) override;
  void end(const RunReport& report) override;

 private:
  std::vector<std::unique_ptr<Observer>> observers_;
};

struct RecordOptions {
  std::string resolved;  // text of resolved.toml: the mission with every default filled in
  BuildInfo build;
  bool overwrite = false;  // remove what an earlier run left in the folder
  bool vtk = true;         // write frames/ and frames.pvd
};

// Prepares the output folder, writes resolved.toml and makes the observers that write everything
// else but report.html. Throws InputError (the folder cannot be used) and RunError.
std::unique_ptr<FanOut> make_recorders(const std::filesystem::path& folder,
                                       const RecordOptions& options);

}  // namespace retiarius

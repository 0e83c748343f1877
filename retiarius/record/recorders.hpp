// The observers of one run, combined into one.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "retiarius/base/build_info.hpp"
#include "retiarius/mission/observer.hpp"
#include "retiarius/record/checkpoint.hpp"

namespace retiarius {

// Passes every call on to several observers, in order; all are told even when some throw, so that a
// full disk for one does not cost the others' files. The first exception of all goes on, once the
// round is over, and ends the run. After it nothing more is thrown, so that the run can come to its
// end; an observer that threw is told only the end.
class FanOut : public Observer {
 public:
  void add(std::unique_ptr<Observer> observer) { parts_.push_back({std::move(observer)}); }

  void begin(const RunModel& model) override;
  void history(const HistoryRow& row) override;
  void frame(const Frame& frame) override;
  void save(const Checkpoint& saved, bool durable) override;
  void resumed() override;
  void progress(const State& state, Index phase, double phase_fraction) override;
  void end(const RunReport& report) override;

 private:
  struct Part {
    std::unique_ptr<Observer> observer;
    bool broken = false;
  };

  template <class Call>
  void each(bool broken_too, Call&& call);

  std::vector<Part> parts_;
  bool failed_ = false;
};

struct RecordOptions {
  std::string resolved;  // text of resolved.toml: the mission with every default filled in
  std::string mission;   // text of mission.toml: the file as it was given; empty: not written
  BuildInfo build;
  bool overwrite = false;  // remove what an earlier run left in the folder
  bool vtk = true;         // write frames/ and frames.pvd
  bool resume = false;     // of a run that goes on in its folder, which is not prepared
};

// What a checkpoint remembers of the run that made it.
RunIdentity run_identity(const RecordOptions& options);

// Prepares the output folder, writes resolved.toml and mission.toml, and makes the observers that
// write everything else but report.html. Throws InputError (the folder cannot be used) and
// RunError.
std::unique_ptr<FanOut> make_recorders(const std::filesystem::path& folder,
                                       const RecordOptions& options);

}  // namespace retiarius

// run.h5: everything recorded, for numpy, xarray and `retiarius export`.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "retiarius/mission/observer.hpp"

namespace retiarius {

inline constexpr int kRunFileFormat = 1;

// On a full disk the file may end before the end that its own header states, and HDF5 refuses it
// then. A hole makes up the difference: it needs no space on the disk and nothing refers to it.
// Where even that is impossible the file stays as it is.
void mend_run_file(const std::filesystem::path& path);

// Writes the file frame by frame in HDF5's single-writer-multiple-reader mode: metadata reach the
// file after what they refer to, so that a process that is killed at any instant leaves a readable
// file with all frames but perhaps the one being written; other processes may read while the run
// goes on. History rows are written with the next frame (or checkpoint). Throws RunError that names
// file and cause.
class RunH5 : public Observer {
 public:
  // `resolved` is the mission with all defaults, kept as an attribute; `version` the program's.
  RunH5(const std::filesystem::path& folder, std::string resolved, std::string version);
  ~RunH5() override;

  void begin(const RunModel& model) override;
  void history(const HistoryRow& row) override;
  void frame(const Frame& frame) override;
  void save(const Checkpoint& saved, bool durable) override;
  void resumed() override;
  void end(const RunReport& report) override;

 private:
  class File;  // keeps HDF5 out of this header

  template <class Call>
  void guarded(const char* what, Call&& call);
  void save_what_is_written();

  std::filesystem::path path_;  // where it is written now
  std::string resolved_, version_;
  std::unique_ptr<File> file_;
  bool broken_ =
      false;  // after an error HDF5's own state cannot be trusted: nothing more is written
};

}  // namespace retiarius

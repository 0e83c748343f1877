// A run folder whose run can go on.
#pragma once

#include <filesystem>
#include <memory>

#include "retiarius/mission/run.hpp"
#include "retiarius/record/checkpoint.hpp"

namespace retiarius {

struct ResumableRun {
  SavedRun saved;
  std::filesystem::path used;  // the checkpoint file
  std::string passed_over;     // why a newer one was not used; empty: there was none
};

// The newest checkpoint of the folder that is whole and whose rows and frames are all in run.h5: a
// machine that stopped may have lost what the newest one counts. One that says that the run has
// ended needs no run.h5. Throws InputError that says why neither can be used.
ResumableRun find_resumable(const std::filesystem::path& folder);

// Throws InputError, naming what differs, unless `now` is the run that was saved, by the same
// program and kernels. model is compared where both have one.
void check_identity(const RunIdentity& saved, const RunIdentity& now);

// What a mission loop needs to go on: tells observers, from run.h5, of all up to the checkpoint.
Resumption resumption(const std::filesystem::path& folder, const ResumableRun& run);

}  // namespace retiarius

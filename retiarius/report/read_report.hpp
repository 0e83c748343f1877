// A report's data from the files that a run left, for making the page again later.
#pragma once

#include <filesystem>

#include "retiarius/report/report_data.hpp"

namespace retiarius {

// Reads summary.json (where there is one: a run that was killed has none) and run.h5 of a run
// folder. Throws InputError that names the file and what is wrong with it.
ReportData read_report(const std::filesystem::path& folder);

// Only what summary.json says, and the title: of the recording where there is no summary. Throws as
// read_report.
ReportData read_outcome(const std::filesystem::path& folder);

}  // namespace retiarius

// report.html and comparisons, made from the folders of runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "retiarius/report/report_data.hpp"

namespace retiarius {

// The page about the run whose files are in `folder`: with the 3D replay where the viewer is built
// in and there is a recording, else the static page, which says what is missing. Throws InputError.
std::string report_page(const std::filesystem::path& folder, const ReportData& data);

// The same from the files alone, with as little reading as the page needs. Throws InputError.
std::string report_page(const std::filesystem::path& folder);

// Several runs side by side, called by the shortest ends of their paths that tell them apart.
// Throws InputError for fewer than two runs, for one that cannot be read, and where the viewer is
// not built in.
std::string comparison_page(const std::vector<std::filesystem::path>& folders);

}  // namespace retiarius

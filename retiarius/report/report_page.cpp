#include "retiarius/report/report_page.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/report/read_report.hpp"
#include "retiarius/report/replay_page.hpp"
#include "retiarius/report/report_heading.hpp"
#include "retiarius/report/report_html.hpp"

namespace retiarius {

namespace fs = std::filesystem;

namespace {

constexpr const char* kNoViewer =
    "This page is without the 3D replay, because the program was built without it. A program built "
    "where Node.js 18 and npm are found has it, and its `retiarius report DIR` makes this page "
    "again from the run's files.";
constexpr const char* kNoRecording =
    "This page is without the 3D replay, because the run's folder has no recording (replay.bin).";

bool can_replay(const fs::path& folder) {
  return viewer_built_in() && fs::exists(folder / "replay.bin");
}

std::string name_of(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::string replay(const fs::path& folder, const ReportData& data) {
  return replay_page(data.title.empty() ? "Mission" : data.title, heading_html(data),
                     {{name_of(folder), folder}});
}

// The last `parts` parts of a path.
std::string path_end(const fs::path& folder, std::ptrdiff_t parts) {
  fs::path path = fs::absolute(folder).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  fs::path end;
  auto part = path.end();
  for (; parts > 0 && part != path.begin(); --parts) end = *--part / end;
  return end.parent_path() == end ? end.string() : end.lexically_normal().string();
}

std::vector<std::string> labels(const std::vector<fs::path>& folders) {
  for (std::ptrdiff_t parts = 1; parts < 100; ++parts) {
    std::vector<std::string> names;
    for (const fs::path& folder : folders) {
      names.push_back(path_end(folder, parts));
      if (names.back().ends_with('/')) names.back().pop_back();
    }
    if (std::set<std::string>(names.begin(), names.end()).size() == names.size()) return names;
  }
  throw InputError("a run cannot be compared with itself; pass different folders");
}

}  // namespace

std::string report_page(const fs::path& folder, const ReportData& data) {
  if (can_replay(folder)) return replay(folder, data);
  return report_html(data, viewer_built_in() ? kNoRecording : kNoViewer);
}

std::string report_page(const fs::path& folder) {
  if (can_replay(folder)) return replay(folder, read_outcome(folder));
  return report_page(folder, read_report(folder));
}

std::string comparison_page(const std::vector<fs::path>& folders) {
  if (folders.size() < 2) throw InputError("a comparison needs two runs or more");
  if (!viewer_built_in())
    throw InputError(
        "runs cannot be compared, because this program was built without the 3D replay; build it "
        "where Node.js 18 and npm are found");
  std::vector<PageRun> runs;
  std::vector<ComparedRun> heading;
  const std::vector<std::string> names = labels(folders);
  for (std::size_t k = 0; k < folders.size(); ++k) {
    runs.push_back({names[k], folders[k]});
    heading.push_back({names[k], read_outcome(folders[k])});
  }
  return replay_page(fmt::format("Comparison of {} runs", runs.size()),
                     comparison_heading_html(heading), runs);
}

}  // namespace retiarius

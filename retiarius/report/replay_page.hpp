// The page that shows runs in 3D: the viewer's page with the runs' files in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace retiarius {

// False where the library was built without the viewer (CMake option RETIARIUS_VIEWER).
bool viewer_built_in();

// One run for the page.
struct PageRun {
  std::string label;             // how it is called beside others
  std::filesystem::path folder;  // with replay.bin and, where they are there, history.csv,
                                 // summary.json, mission.toml and resolved.toml
};

// A self-contained page that asks the network for nothing. `heading` is the HTML of its first
// element, which tells the outcome in words. Of a recording that was cut off the whole chunks are
// taken. Throws InputError that names the file where there is no recording or a damaged one, Error
// where the viewer was not built.
std::string replay_page(const std::string& title, const std::string& heading,
                        const std::vector<PageRun>& runs);

// The same page without runs: it asks the server it comes from for replay.bin (by byte range),
// history.csv, summary.json, mission.toml and resolved.toml, by addresses relative to its own, and
// follows the run until there is a summary. Throws Error where the viewer was not built.
std::string live_page(const std::string& title);

// Base64 with padding, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace retiarius

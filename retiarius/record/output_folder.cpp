#include "retiarius/record/output_folder.hpp"

#include <array>
#include <system_error>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius {

namespace fs = std::filesystem;

namespace {

// Everything a run may leave, so that overwriting never touches a file of the user's.
constexpr std::array kRunFiles = {
    "history.csv",         "frames",       "frames.pvd",      "run.h5",        "checkpoint",
    "checkpoint.previous", "summary.json", "report.html",     "resolved.toml", "checkpoint.new",
    "replay.bin",          "mission.toml", "history.csv.new", "run.h5.new",    "replay.bin.new"};

[[noreturn]] void refuse(const fs::path& folder, const std::string& cause) {
  throw InputError(
      fmt::format("cannot write results to {}: {}; pass another --out", folder.string(), cause));
}

// The surest way to know that a place takes files is to write one.
void try_writing(const fs::path& folder) {
  const fs::path probe = folder / ".retiarius-write-test";
  std::error_code ignored;
  try {
    OutputFile file(probe);
    file.write("x");
    file.sync();
    file.close();
  } catch (const RunError& error) {
    fs::remove(probe, ignored);
    throw InputError(fmt::format("{}; pass another --out", error.what()));
  }
  fs::remove(probe, ignored);
}

void remove_earlier_run(const fs::path& folder) {
  for (const char* name : kRunFiles) {
    std::error_code error;
    fs::remove_all(folder / name, error);
    if (error) refuse(folder, fmt::format("cannot remove its {}: {}", name, error.message()));
  }
}

}  // namespace

void prepare_output_folder(const fs::path& folder, bool overwrite) {
  if (folder.empty()) throw InputError("the output folder has an empty name; pass another --out");
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (fs::exists(status) && !fs::is_directory(status)) refuse(folder, "it is not a folder");
  fs::create_directories(folder, error);
  if (error) refuse(folder, error.message());
  const bool empty = fs::is_empty(folder, error);
  if (error) refuse(folder, error.message());
  if (!empty && !overwrite)
    throw InputError(
        fmt::format("the output folder {} exists and is not empty; pass another --out or remove it",
                    folder.string()));
  if (!empty) remove_earlier_run(folder);
  try_writing(folder);
}

}  // namespace retiarius

#include "program/output_guard.hpp"

#include <system_error>

namespace retiarius::program {

namespace fs = std::filesystem;

OutputGuard::OutputGuard(const fs::path& folder) {
  std::error_code error;
  fs::path path = fs::absolute(folder, error).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  while (!error && path.has_relative_path() && !fs::exists(fs::symlink_status(path, error))) {
    error.clear();  // "not found" is the answer looked for
    missing_.push_back(path);
    path = path.parent_path();
  }
}

OutputGuard::~OutputGuard() {
  std::error_code error;
  for (const fs::path& path : missing_)
    if (fs::is_directory(path, error)) fs::remove(path, error);
}

}  // namespace retiarius::program

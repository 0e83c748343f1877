// Takes an output folder back when it turns out that nothing will be written into it.
#pragma once

#include <filesystem>
#include <vector>

namespace retiarius::program {

// Remembers at construction which folders of a path do not exist yet; on destruction, unless kept,
// removes those of them that are empty. Files are never removed.
class OutputGuard {
 public:
  explicit OutputGuard(const std::filesystem::path& folder);
  ~OutputGuard();
  OutputGuard(const OutputGuard&) = delete;
  OutputGuard& operator=(const OutputGuard&) = delete;

  void keep() { missing_.clear(); }

 private:
  std::vector<std::filesystem::path> missing_;  // the innermost first
};

}  // namespace retiarius::program

// Keeps two processes from writing the same run.
#pragma once

#include <filesystem>

namespace retiarius {

// Holds a folder until it is destroyed or the process ends, however it ends. Where the file system
// has no locks it holds nothing. Throws InputError where another process holds the folder.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace retiarius

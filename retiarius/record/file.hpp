// Files whose every write is checked, so that a full disk is an error and never a silent loss.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace retiarius {

// A file opened for writing, emptied first. Every member function throws RunError that names file
// and cause. Unbuffered: each write reaches the operating system before it returns.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);
  void sync();  // waits until the data are on the device
  // Syncs, and gives the open file this name in place of whatever has it.
  void rename_to(const std::filesystem::path& path);
  void close();  // further writes are errors

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

// Writes `bytes` to a temporary file in the same folder, syncs it and renames it to `path`: at any
// instant a reader sees either the whole old or the whole new content. Throws RunError.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

// The name of a file that is yet to take the place of the one at `path`.
std::filesystem::path new_name(const std::filesystem::path& path);

// Renames a file in its folder and syncs the folder. Throws RunError.
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

// As write_atomically, but without waiting for the device: a reader sees the old or the new content
// unless the machine stops.
void write_replacing(const std::filesystem::path& path, std::string_view bytes);

// The same, durable or not, and what was at `path` before is kept at `previous`.
void replace_keeping(const std::filesystem::path& path, const std::filesystem::path& previous,
                     std::string_view bytes, bool durable = true);

// The whole content of a file. Throws InputError that names file and cause.
std::string read_whole_file(const std::filesystem::path& path);

}  // namespace retiarius

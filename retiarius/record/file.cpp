#include "retiarius/record/file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  const int cause = errno;
  throw RunError(fmt::format("cannot {} {}: {}", what, path.string(), std::strerror(cause)));
}

// A rename is on the device only when the folder that holds the name is.
void sync_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path parent = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) fail(parent, "open");
  // Some file systems cannot sync a folder and say so; the rename itself is atomic anyway.
  (void)::fsync(descriptor);
  ::close(descriptor);
}

std::filesystem::path write_temporary(const std::filesystem::path& path, std::string_view bytes,
                                      bool sync = true) {
  const std::filesystem::path temporary = new_name(path);
  try {
    OutputFile file(temporary);
    file.write(bytes);
    if (sync) file.sync();
    file.close();
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  return temporary;
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) fail(to, "write");
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path) {
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, "create");
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, "write");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::sync() {
  // Devices and pipes have nothing to sync and answer EINVAL.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail(path_, "write");
}

void OutputFile::close() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail(path_, "write");
}

void OutputFile::rename_to(const std::filesystem::path& path) {
  sync();
  rename_durably(path_, path);
  path_ = path;
}

std::filesystem::path new_name(const std::filesystem::path& path) {
  std::filesystem::path name = path;
  name += ".new";
  return name;
}

void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to) {
  rename_file(from, to);
  sync_folder_of(to);
}

void write_replacing(const std::filesystem::path& path, std::string_view bytes) {
  rename_file(write_temporary(path, bytes, false), path);
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes) {
  rename_durably(write_temporary(path, bytes), path);
}

void replace_keeping(const std::filesystem::path& path, const std::filesystem::path& previous,
                     std::string_view bytes, bool durable) {
  const std::filesystem::path temporary = write_temporary(path, bytes, durable);
  if (std::filesystem::exists(path)) rename_file(path, previous);
  rename_file(temporary, path);
  if (durable) sync_folder_of(path);
}

std::string read_whole_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(fmt::format("cannot read {}: it is a folder", path.string()));
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  if (!stream) {
    const int cause = errno == 0 ? EIO : errno;
    throw InputError(fmt::format("cannot read {}: {}", path.string(), std::strerror(cause)));
  }
  return std::move(text).str();
}

}  // namespace retiarius

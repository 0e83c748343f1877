// retiarius new NAME: a commented mission to start from.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "program/commands.hpp"
#include "program/console.hpp"
#include "retiarius/base/error.hpp"
#include "retiarius/mission/writer.hpp"

namespace retiarius::program {

namespace {

namespace fs = std::filesystem;

// NAME.toml; a name that ends so already stays.
fs::path mission_path(const std::string& name) {
  fs::path path(name);
  if (path.filename().empty() || path.filename() == "." || path.filename() == "..")
    throw InputError(fmt::format("\"{}\" names no file; give a name such as `first`", name));
  if (path.extension() != ".toml") path += ".toml";
  return path;
}

// Creates the file; one that exists stays as it is.
void write_new_file(const fs::path& path, const std::string& text) {
  std::FILE* file = std::fopen(path.c_str(), "wx");
  if (file == nullptr) {
    const int cause = errno;
    if (cause == EEXIST)
      throw InputError(
          fmt::format("{} exists and is not overwritten; give another name", path.string()));
    throw InputError(fmt::format("cannot write {}: {}", path.string(), std::strerror(cause)));
  }
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const bool closed = std::fclose(file) == 0;
  if (written && closed) return;
  const int cause = errno;
  std::error_code ignored;
  fs::remove(path, ignored);
  throw RunError(fmt::format("cannot write {}: {}", path.string(), std::strerror(cause)));
}

}  // namespace

void add_new_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("new", "Write a commented mission to start from");
  auto name = std::make_shared<std::string>();
  command->add_option("NAME", *name, "NAME.toml is written; an existing file stays as it is")
      ->required()
      ->type_name("");
  command->callback([name] {
    const fs::path path = mission_path(*name);
    write_new_file(path, starter_mission(path.stem().string()));
    print(fmt::format("{0} written; run it with: retiarius run {0}\n", path.string()));
  });
}

}  // namespace retiarius::program

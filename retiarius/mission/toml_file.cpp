#include "retiarius/mission/toml_file.hpp"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/table_source.hpp"

namespace retiarius {

namespace fs = std::filesystem;

std::string read_toml_file(const std::string& path, const TomlFileKind& kind) {
  const SourcePlace place{path, 0, 0};
  std::error_code error;
  if (path.empty()) throw InputError(fmt::format("the name of the {} file is empty", kind.name));
  if (!fs::exists(path, error))
    throw InputError(place, fmt::format("there is no such {} file", kind.name));
  if (fs::is_directory(path, error))
    throw InputError(place, fmt::format("is a folder; a {} file is expected", kind.name));
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(place, "cannot be read; check its permissions");
  // Such a file has a few thousand bytes; devices may have no end.
  constexpr std::size_t kLargest = 16u << 20;
  std::string text(kLargest + 1, ' ');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > kLargest) {
    throw InputError(place, fmt::format("is larger than 16 MiB; a {} file is expected", kind.name));
  }
  if (in.bad()) throw InputError(place, "cannot be read to its end");
  return text;
}

toml::table parse_toml(const std::string& text, const std::string& name, const TomlFileKind& kind) {
  const SourcePlace place{name, 0, 0};
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(place, "is empty; " + kind.needs);
  }
  const auto zero = text.find('\0');
  if (zero != std::string::npos) {
    throw InputError(place, fmt::format("is not a text file (byte {} is zero)", zero));
  }
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(error.source(), name),
                     fmt::format("syntax error: {}", error.description()));
  }
}

}  // namespace retiarius

#include "program/served_folder.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace retiarius::program {

namespace fs = std::filesystem;

namespace {

bool plain(const fs::path& part) {
  const std::string text = part.string();
  return !text.empty() && text[0] != '.';
}

}  // namespace

std::optional<fs::path> served_file(const fs::path& folder, std::string_view path) {
  if (path.size() < 2 || path[0] != '/' || path[1] == '/') return {};
  if (path.find('\0') != std::string_view::npos || path.find('\\') != std::string_view::npos)
    return {};
  const fs::path below(path.substr(1));
  if (below.is_absolute() || !std::all_of(below.begin(), below.end(), plain)) return {};
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error) return {};
  // Links are followed here: what they lead to must lie below the folder too.
  const fs::path file = fs::canonical(root / below, error);
  if (error || !fs::is_regular_file(file, error) || error) return {};
  const auto [end, rest] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  if (end != root.end()) return {};
  return file;
}

std::string media_type(const fs::path& file) {
  static const std::array<std::pair<const char*, const char*>, 10> types = {{
      {".html", "text/html; charset=utf-8"},
      {".json", "application/json"},
      {".csv", "text/csv; charset=utf-8"},
      {".toml", "text/plain; charset=utf-8"},
      {".pvd", "application/xml"},
      {".vtp", "application/xml"},
      {".png", "image/png"},
      {".svg", "image/svg+xml"},
      {".pdf", "application/pdf"},
      {".glb", "model/gltf-binary"},
  }};
  for (const auto& [end, type] : types)
    if (file.extension() == end) return type;
  return "application/octet-stream";
}

bool is_loopback(const std::string& host) {
  return host == "localhost" || host == "::1" || host.rfind("127.", 0) == 0;
}

bool names_loopback(std::string_view host) {
  if (!host.empty() && host[0] == '[') {
    const std::size_t end = host.find(']');
    return end != std::string_view::npos && is_loopback(std::string(host.substr(1, end - 1)));
  }
  const std::string name(host.substr(0, host.find(':')));
  // "127.0.0.1.example.org" is a name that anyone can own.
  if (name.rfind("127.", 0) == 0) return name.find_first_not_of("0123456789.") == std::string::npos;
  return is_loopback(name);
}

}  // namespace retiarius::program

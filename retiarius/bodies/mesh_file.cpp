#include "retiarius/bodies/mesh_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {
namespace {

std::string read_all(const std::string& path) {
  const SourcePlace place{path};
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw InputError(place, "no such mesh file");
  }
  if (status.type() == std::filesystem::file_type::directory) {
    throw InputError(place, "is a directory; an STL or OBJ file is wanted");
  }
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad() || !stream.is_open()) throw InputError(place, "the mesh file cannot be read");
  return std::move(content).str();
}

}  // namespace

double parse_coordinate(const std::string& word, const std::string& path, int line) {
  const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* last = word.data() + word.size();
  double value = 0.0;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last) {
    throw InputError(SourcePlace{path, line}, fmt::format("\"{}\" is not a number", word));
  }
  if (!std::isfinite(value)) {
    throw InputError(SourcePlace{path, line},
                     fmt::format("the coordinate \"{}\" is not finite", word));
  }
  return value;
}

TriangleMesh read_mesh(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending != ".stl" && ending != ".obj") {
    throw InputError(SourcePlace{path}, "the name of a mesh file must end in .stl or .obj");
  }
  const std::string content = read_all(path);
  if (content.empty()) throw InputError(SourcePlace{path}, "the mesh file is empty");
  TriangleMesh mesh = ending == ".stl" ? parse_stl(content, path) : parse_obj(content, path);
  if (mesh.triangles.empty()) throw InputError(SourcePlace{path}, "the mesh has no triangles");
  return mesh;
}

}  // namespace retiarius

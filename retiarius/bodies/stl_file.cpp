#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/mesh_file.hpp"

namespace retiarius {
namespace {

constexpr std::size_t kHeader = 84;  // 80 bytes of any text, then the count of triangles
constexpr std::size_t kRecord = 50;  // normal, three vertices (12 floats), two bytes of attributes

void add_triangle(TriangleMesh& mesh, const std::array<Vec3, 3>& corners) {
  const Index first = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
}

std::uint32_t binary_count(const std::string& content) {
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + kHeader - 4, 4);
  return count;
}

bool is_binary(const std::string& content) {
  return content.size() >= kHeader &&
         content.size() == kHeader + kRecord * static_cast<std::size_t>(binary_count(content));
}

TriangleMesh parse_binary(const std::string& content, const std::string& path) {
  TriangleMesh mesh;
  for (std::size_t at = kHeader; at < content.size(); at += kRecord) {
    std::array<float, 9> number;
    std::memcpy(number.data(), content.data() + at + 12, sizeof number);
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = Vec3(number[3 * k], number[3 * k + 1], number[3 * k + 2]);
      if (corners[k].allFinite()) continue;
      throw InputError(SourcePlace{path}, fmt::format("triangle {} has a coordinate that is not "
                                                      "finite",
                                                      mesh.triangles.size() + 1));
    }
    add_triangle(mesh, corners);
  }
  return mesh;
}

// Reads the words of text STL line by line; normals are ignored, because the order of the vertices
// says the same and more exactly.
class TextReader {
 public:
  explicit TextReader(const std::string& path) : path_(path) {}

  TriangleMesh read(const std::string& content) {
    std::istringstream stream(content);
    std::string text;
    while (std::getline(stream, text)) {
      ++line_;
      read_line(text);
    }
    if (count_ >= 0) fail("the file ends within a facet");
    return std::move(mesh_);
  }

 private:
  void read_line(const std::string& text) {
    std::istringstream words(text);
    std::string word;
    if (!(words >> word)) return;
    if (word == "vertex") {
      read_vertex(words);
    } else if (word == "outer") {
      if (count_ >= 0) fail("\"outer loop\" within another");
      count_ = 0;
    } else if (word == "endloop") {
      if (count_ != 3) fail(fmt::format("a facet has {} vertices; it must have 3", count_));
      add_triangle(mesh_, corners_);
      count_ = -1;
    } else if (word != "solid" && word != "endsolid" && word != "facet" && word != "endfacet") {
      fail(fmt::format("unknown word \"{}\"; this is neither text nor whole binary STL",
                       word.substr(0, 20)));
    }
  }

  void read_vertex(std::istringstream& words) {
    if (count_ < 0) fail("\"vertex\" outside of \"outer loop\"");
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      std::string word;
      if (!(words >> word)) fail("a vertex needs three numbers");
      point[axis] = parse_coordinate(word, path_, line_);
    }
    if (count_ < 3) corners_[static_cast<std::size_t>(count_)] = point;
    ++count_;
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(SourcePlace{path_, line_}, message);
  }

  std::string path_;
  TriangleMesh mesh_;
  std::array<Vec3, 3> corners_;
  int count_ = -1;  // of vertices in the open loop, -1 outside
  int line_ = 0;
};

}  // namespace

TriangleMesh parse_stl(const std::string& content, const std::string& path) {
  if (is_binary(content)) return parse_binary(content, path);
  if (content.find('\0') != std::string::npos || !content.starts_with("solid")) {
    const std::string expected =
        content.size() < kHeader
            ? "is too short for binary STL"
            : fmt::format("has {} bytes, where binary STL of {} triangles has {}", content.size(),
                          binary_count(content),
                          kHeader + kRecord * static_cast<std::size_t>(binary_count(content)));
    throw InputError(
        SourcePlace{path},
        "not an STL file: it does not begin with \"solid\" as text does, and " + expected);
  }
  return TextReader(path).read(content);
}

}  // namespace retiarius

#include <sstream>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/mesh_file.hpp"

namespace retiarius {
namespace {

// tinyobjloader reads what is no number as zero, so the vertices are checked before.
void check_vertices(const std::string& content, const std::string& path) {
  if (content.find('\0') != std::string::npos) {
    throw InputError(SourcePlace{path}, "not an OBJ file: it holds binary data");
  }
  std::istringstream stream(content);
  std::string text;
  for (int line = 1; std::getline(stream, text); ++line) {
    std::istringstream words(text);
    std::string word;
    if (!(words >> word) || word != "v") continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(words >> word)) {
        throw InputError(SourcePlace{path, line}, "a vertex needs three numbers");
      }
      parse_coordinate(word, path, line);
    }
  }
}

}  // namespace

TriangleMesh parse_obj(const std::string& content, const std::string& path) {
  check_vertices(content, path);
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  std::istringstream stream(content);
  const bool ok = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream);
  if (!ok || !error.empty()) {
    throw InputError(SourcePlace{path}, "not a readable OBJ file: " + error);
  }
  TriangleMesh mesh;
  for (std::size_t k = 0; k + 2 < attributes.vertices.size(); k += 3) {
    mesh.vertices.emplace_back(&attributes.vertices[k]);
  }
  const auto count = static_cast<Index>(mesh.vertices.size());
  for (const auto& shape : shapes) {
    const auto& corners = shape.mesh.indices;
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) {
      std::array<Index, 3> triangle;
      for (std::size_t j = 0; j < 3; ++j) {
        triangle[j] = corners[k + j].vertex_index;
        if (triangle[j] >= 0 && triangle[j] < count) continue;
        throw InputError(SourcePlace{path},
                         fmt::format("a face names vertex {}, but the file has {} vertices",
                                     triangle[j] + 1, count));
      }
      mesh.triangles.push_back(triangle);
    }
  }
  return mesh;
}

}  // namespace retiarius

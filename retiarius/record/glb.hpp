// glTF 2.0 in one binary file (.glb), as Blender and common viewers open it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace retiarius {

// What an accessor's numbers are for: it decides how their part of the buffer is marked.
enum class GlbUse { vertices, indices, other };

// Collects numbers into the buffer and describes them. Only for the sources of record/.
class GlbBuffer {
 public:
  using Json = nlohmann::ordered_json;

  // `type` is SCALAR, VEC3, VEC4, MAT4; `bounds` adds min and max, which glTF demands of positions
  // and of the times of animations. Each returns the accessor's number.
  int add(const std::vector<float>& numbers, const char* type, GlbUse use, bool bounds = false);
  int add(const std::vector<std::uint32_t>& numbers, GlbUse use);
  int add(const std::vector<std::uint16_t>& numbers, const char* type, GlbUse use);
  int add_normalized(const std::vector<std::uint8_t>& numbers, const char* type, GlbUse use);

  // The whole file: the document with this buffer, its views and accessors.
  std::string file(Json document) const;

 private:
  int add(std::string_view bytes, std::size_t count, int component, const char* type, GlbUse use);

  std::string bytes_;
  Json views_ = Json::array(), accessors_ = Json::array();
};

}  // namespace retiarius

#include "retiarius/record/glb.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

// Component types and targets have these numbers in glTF.
constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kVertices = 34962, kIndices = 34963;

std::size_t width_of(const char* type) {
  const std::string_view name = type;
  return name == "SCALAR" ? 1 : name == "VEC3" ? 3 : name == "VEC4" ? 4 : 16;
}

template <class T>
std::string_view bytes_of(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

void pad(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes += with;
}

void put(std::string& bytes, std::uint32_t number) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(number >> (8 * k) & 255u);
}

}  // namespace

int GlbBuffer::add(std::string_view bytes, std::size_t count, int component, const char* type,
                   GlbUse use) {
  Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
  if (use != GlbUse::other) view["target"] = use == GlbUse::vertices ? kVertices : kIndices;
  bytes_ += bytes;
  pad(bytes_, '\0');
  accessors_.push_back({{"bufferView", views_.size()},
                        {"componentType", component},
                        {"count", count},
                        {"type", type}});
  views_.push_back(std::move(view));
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::add(const std::vector<float>& numbers, const char* type, GlbUse use, bool bounds) {
  const std::size_t width = width_of(type);
  const int number = add(bytes_of(numbers), numbers.size() / width, kFloat, type, use);
  if (!bounds) return number;
  std::vector<float> low(width, std::numeric_limits<float>::max()), high(width, -low[0]);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    low[k % width] = std::min(low[k % width], numbers[k]);
    high[k % width] = std::max(high[k % width], numbers[k]);
  }
  accessors_.back()["min"] = low;
  accessors_.back()["max"] = high;
  return number;
}

int GlbBuffer::add(const std::vector<std::uint32_t>& numbers, GlbUse use) {
  return add(bytes_of(numbers), numbers.size(), kUnsignedInt, "SCALAR", use);
}

int GlbBuffer::add(const std::vector<std::uint16_t>& numbers, const char* type, GlbUse use) {
  return add(bytes_of(numbers), numbers.size() / width_of(type), kUnsignedShort, type, use);
}

int GlbBuffer::add_normalized(const std::vector<std::uint8_t>& numbers, const char* type,
                              GlbUse use) {
  const int number =
      add(bytes_of(numbers), numbers.size() / width_of(type), kUnsignedByte, type, use);
  accessors_.back()["normalized"] = true;
  return number;
}

std::string GlbBuffer::file(Json document) const {
  document["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
  document["bufferViews"] = views_;
  document["accessors"] = accessors_;
  std::string text = document.dump();
  pad(text, ' ');
  const std::size_t size = 12 + 8 + text.size() + 8 + bytes_.size();
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw Error("the scene is larger than a .glb file can be (4 GiB)");
  std::string file = "glTF";
  put(file, 2);
  put(file, static_cast<std::uint32_t>(size));
  put(file, static_cast<std::uint32_t>(text.size()));
  file += "JSON" + text;
  put(file, static_cast<std::uint32_t>(bytes_.size()));
  file += std::string("BIN\0", 4) + bytes_;
  return file;
}

}  // namespace retiarius

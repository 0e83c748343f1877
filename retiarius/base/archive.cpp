#include "retiarius/base/archive.hpp"

#include <bit>
#include <cstring>

#include "retiarius/base/error.hpp"

namespace retiarius {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

void Archive::raw(void* bytes, std::size_t count) {
  if (count == 0) return;
  if (!reads_) {
    written_.append(static_cast<const char*>(bytes), count);
    return;
  }
  if (count > left_.size()) throw Error("it ends too early");
  std::memcpy(bytes, left_.data(), count);
  left_.remove_prefix(count);
}

std::size_t Archive::length(std::size_t actual) {
  std::uint64_t count = actual;
  raw(&count, sizeof count);
  if (reads_ && count > left_.size()) throw Error("it ends too early");
  return static_cast<std::size_t>(count);
}

void transfer(Archive& archive, bool& truth) {
  auto byte = static_cast<unsigned char>(truth ? 1 : 0);
  archive.raw(&byte, 1);
  truth = byte != 0;
}

void transfer(Archive& archive, Vec3& vector) { archive.raw(vector.data(), 3 * sizeof(double)); }

void transfer(Archive& archive, Quat& attitude) {
  archive.raw(attitude.coeffs().data(), 4 * sizeof(double));
}

void transfer(Archive& archive, std::string& text) {
  text.resize(archive.length(text.size()));
  archive.raw(text.data(), text.size());
}

void transfer(Archive& archive, std::vector<bool>& list) {
  list.resize(archive.length(list.size()));
  for (std::size_t k = 0; k < list.size(); ++k) {
    bool truth = list[k];
    transfer(archive, truth);
    list[k] = truth;
  }
}

void transfer(Archive& archive, std::vector<double>& list) {
  std::size_t count = archive.length(list.size());
  list.resize(count);
  archive.raw(list.data(), count * sizeof(double));
}

}  // namespace retiarius

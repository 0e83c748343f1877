// Values as bytes and back, from one list of members for both directions.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// Either writes the values that it is given, or sets them from bytes. A class takes part with a
// member function transfer(Archive&), or a free one, that hands on its members:
//
//   void transfer(Archive& archive) { archive(time_, places_); }
//
// Numbers are little endian, lists begin with their length (64 bits); floating-point numbers come
// back bit for bit. Bytes of nonsense throw Error and never ask for more than a few times their own
// memory.
class Archive {
 public:
  Archive() = default;  // that writes
  explicit Archive(std::string_view bytes) : reads_(true), left_(bytes) {}

  bool reads() const { return reads_; }

  template <class... Values>
  void operator()(Values&... values) {
    (transfer(*this, values), ...);
  }

  // So many bytes as they lie in memory. Throws Error where there are not so many.
  void raw(void* bytes, std::size_t count);

  // The length of a list whose elements have at least one byte: `actual` while writing.
  std::size_t length(std::size_t actual);

  std::string take() { return std::move(written_); }
  bool finished() const { return left_.empty(); }  // all bytes are read

 private:
  bool reads_ = false;
  std::string written_;
  std::string_view left_;
};

template <class Number>
requires std::is_same_v<Number, double> || std::is_same_v<Number, std::int32_t> ||
    std::is_same_v<Number, std::int64_t> || std::is_same_v<Number, std::uint64_t>
void transfer(Archive& archive, Number& number) { archive.raw(&number, sizeof number); }

template <class Choice>
requires std::is_enum_v<Choice>
void transfer(Archive& archive, Choice& choice) {
  auto number = static_cast<std::int32_t>(choice);
  transfer(archive, number);
  choice = static_cast<Choice>(number);
}

void transfer(Archive& archive, bool& truth);
void transfer(Archive& archive, Vec3& vector);
void transfer(Archive& archive, Quat& attitude);
void transfer(Archive& archive, std::string& text);
void transfer(Archive& archive, std::vector<bool>& list);
void transfer(Archive& archive, std::vector<double>& list);

template <class Object>
requires requires(Object& object, Archive& archive) { object.transfer(archive); }
void transfer(Archive& archive, Object& object) { object.transfer(archive); }

template <class Element>
void transfer(Archive& archive, std::vector<Element>& list) {
  list.resize(archive.length(list.size()));
  for (Element& element : list) transfer(archive, element);
}

template <class Element>
void transfer(Archive& archive, std::deque<Element>& list) {
  list.resize(archive.length(list.size()));
  for (Element& element : list) transfer(archive, element);
}

template <class Value>
void transfer(Archive& archive, std::optional<Value>& value) {
  bool present = value.has_value();
  transfer(archive, present);
  if (!present) {
    value.reset();
    return;
  }
  if (!value) value.emplace();
  transfer(archive, *value);
}

}  // namespace retiarius

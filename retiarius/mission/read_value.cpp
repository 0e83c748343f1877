#include "retiarius/mission/read_value.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "retiarius/mission/nearest.hpp"

namespace retiarius {

namespace {

class ValueReader {
 public:
  ValueReader(const toml::node& node, const KeyInfo& key, const std::string& path,
              const SourcePlace& place)
      : node_(node), key_(key), path_(path), place_(place) {}

  KeyValue read() const {
    const KeyValue value = by_type();
    if (key_.refuse) {
      const std::string why = key_.refuse(value);
      if (!why.empty()) fail(why);
    }
    return value;
  }

 private:
  KeyValue by_type() const {
    switch (key_.type) {
      case KeyType::number:
        return number(node_);
      case KeyType::integer:
        return integer();
      case KeyType::boolean:
        if (!node_.is_boolean()) wrong_type();
        return **node_.as_boolean();
      case KeyType::text:
        return text(node_);
      case KeyType::word:
        return word();
      case KeyType::vec3:
        return vec3();
      case KeyType::numbers:
        return numbers();
      case KeyType::texts:
        return texts();
      case KeyType::node:
        return name_or_index(node_);
    }
    return {};
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(place_, fmt::format("{} = {}: {}", path_, node_text(node_), why));
  }

  [[noreturn]] void wrong_type() const {
    std::string must = type_text(key_.type);
    if (key_.type == KeyType::word) must = "one of " + word_list();
    if (!key_.unit.empty()) must += " in " + key_.unit;
    fail(fmt::format("must be {}", must));
  }

  std::string word_list() const {
    std::vector<std::string> out;
    for (const auto& w : key_.words) out.push_back(quoted(w));
    return fmt::format("{}", fmt::join(out, ", "));
  }

  double number(const toml::node& node) const {
    if (!node.is_number()) wrong_type();
    const double value = *node.value<double>();
    if (key_.range.holds(value)) return value;
    if (!std::isfinite(value)) fail("must be a finite number");
    fail(fmt::format("must be {}{}", key_.range.text(), key_.unit.empty() ? "" : " " + key_.unit));
  }

  KeyValue integer() const {
    if (!node_.is_integer()) wrong_type();
    const std::int64_t value = **node_.as_integer();
    if (!key_.range.holds(static_cast<double>(value))) {
      fail(fmt::format("must be {}", key_.range.text()));
    }
    return value;
  }

  std::string text(const toml::node& node) const {
    if (!node.is_string()) wrong_type();
    const std::string& value = **node.as_string();
    if (value.find('\0') != std::string::npos) fail("must not contain a zero character");
    if (value.empty() && (key_.required || key_.type == KeyType::texts)) fail("must not be empty");
    return value;
  }

  KeyValue word() const {
    if (!node_.is_string()) wrong_type();
    const std::string value = **node_.as_string();
    if (std::find(key_.words.begin(), key_.words.end(), value) != key_.words.end()) return value;
    if (std::find(key_.planned.begin(), key_.planned.end(), value) != key_.planned.end()) {
      fail("is not available yet; available: " + word_list());
    }
    const auto name = nearest(value, key_.words);
    fail(fmt::format("must be one of {}{}", word_list(),
                     name ? fmt::format(", did you mean {}?", *name) : ""));
  }

  KeyValue vec3() const {
    const toml::array* array = node_.as_array();
    if (!array || array->size() != 3) wrong_type();
    return list(*array);
  }

  std::vector<double> list(const toml::array& array) const {
    std::vector<double> out;
    for (const toml::node& item : array) out.push_back(number(item));
    return out;
  }

  KeyValue numbers() const {
    const toml::array* array = node_.as_array();
    if (!array) return std::vector<double>{number(node_)};
    if (array->empty()) fail("must not be an empty list");
    return list(*array);
  }

  KeyValue texts() const {
    const toml::array* array = node_.as_array();
    if (!array) return std::vector<std::string>{name_or_index(node_)};
    if (array->empty()) fail("must not be an empty list");
    std::vector<std::string> out;
    for (const toml::node& item : *array) out.push_back(name_or_index(item));
    return out;
  }

  // An index may stand for a name wherever nodes are named.
  std::string name_or_index(const toml::node& node) const {
    if (!node.is_integer()) return text(node);
    const std::int64_t index = **node.as_integer();
    if (index < 0) fail("an index must be at least 0");
    return std::to_string(index);
  }

  const toml::node& node_;
  const KeyInfo& key_;
  const std::string& path_;
  const SourcePlace& place_;
};

}  // namespace

std::string node_text(const toml::node& node) {
  if (node.is_table()) return "a table";
  std::string text;
  if (node.is_string()) {
    text = quoted(**node.as_string());
  } else if (node.is_floating_point()) {
    text = number_text(**node.as_floating_point());
  } else {
    std::ostringstream out;
    node.visit([&out](const auto& n) {
      if constexpr (toml::is_array<decltype(n)>) {
        out << toml::toml_formatter(n);
      } else if constexpr (!toml::is_table<decltype(n)>) {
        out << n;
      }
    });
    text = out.str();
  }
  constexpr std::size_t kLongest = 80;
  if (text.size() > kLongest) text = text.substr(0, kLongest - 3) + "...";
  return text;
}

KeyValue read_value(const toml::node& node, const KeyInfo& key, const std::string& path,
                    const SourcePlace& place) {
  return ValueReader(node, key, path, place).read();
}

}  // namespace retiarius

// The keys of the mission file: what each is called, means, may hold, and which member it fills.
// The tables in schema_*.cpp are made of these; reader, defaults, the resolved mission, the
// documentation and the tests all come from them.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// numbers: a number or a list of numbers; texts: a text or a list of texts; node: a text or an
// index; word: one of a fixed set.
enum class KeyType { number, integer, boolean, text, word, vec3, numbers, texts, node };

// The value of a key apart from its struct; monostate is "absent". A vec3 is a list of three.
using KeyValue = std::variant<std::monostate, bool, std::int64_t, double, std::string,
                              std::vector<double>, std::vector<std::string>>;

// What a number may be; also each number of a list.
struct Range {
  double low = -kInfinity;
  double high = kInfinity;
  bool above = false;     // true: `low` itself is excluded
  bool infinite = false;  // true: inf is accepted

  bool holds(double value) const;
  std::string text() const;  // "greater than 0", "from 0 to 90"; empty if anything finite will do
};

// A key without its binding.
struct KeyInfo {
  std::string name;
  KeyType type = KeyType::number;
  std::string unit;
  std::string meaning;
  bool required = false;
  Range range;
  std::vector<std::string> words;    // that a key of type word accepts
  std::vector<std::string> planned;  // words that mean something but are not available
  std::vector<std::string> owners;   // words of the table's selector it belongs to; empty: all
  std::string default_text;          // what holds where `standard` is absent
  bool path = false;                 // a file or folder, relative to the mission file
  KeyValue standard;                 // the default
  std::string (*refuse)(const KeyValue&) = nullptr;  // why a value is refused; empty: it is not

  bool belongs_to(const std::string& selected) const;
};

std::string type_text(KeyType type);            // "a number", "a list of three numbers", ...
std::string value_text(const KeyValue& value);  // as TOML; shortest text that reads back the same
std::string number_text(double value);          // as a TOML float
std::string quoted(const std::string& text);    // as a TOML basic string

// Conversions between members and values.
inline KeyValue to_value(double v) { return v; }
inline KeyValue to_value(bool v) { return v; }
inline KeyValue to_value(const std::string& v) { return v; }
inline KeyValue to_value(const Vec3& v) { return std::vector<double>{v.x(), v.y(), v.z()}; }
inline KeyValue to_value(const std::array<double, 3>& v) {
  return std::vector<double>(v.begin(), v.end());
}
inline KeyValue to_value(const std::vector<double>& v) { return v; }
inline KeyValue to_value(const std::vector<std::string>& v) { return v; }
template <std::integral T>
requires(!std::same_as<T, bool>) KeyValue to_value(T v) { return static_cast<std::int64_t>(v); }
template <class T>
KeyValue to_value(const std::optional<T>& v) {
  return v ? to_value(*v) : KeyValue{};
}

inline void from_value(const KeyValue& value, double& v) { v = std::get<double>(value); }
inline void from_value(const KeyValue& value, bool& v) { v = std::get<bool>(value); }
inline void from_value(const KeyValue& value, std::string& v) { v = std::get<std::string>(value); }
inline void from_value(const KeyValue& value, Vec3& v) {
  v = Eigen::Map<const Vec3>(std::get<std::vector<double>>(value).data());
}
inline void from_value(const KeyValue& value, std::array<double, 3>& v) {
  const auto& list = std::get<std::vector<double>>(value);
  v = {list[0], list[1], list[2]};
}
inline void from_value(const KeyValue& value, std::vector<double>& v) {
  v = std::get<std::vector<double>>(value);
}
inline void from_value(const KeyValue& value, std::vector<std::string>& v) {
  v = std::get<std::vector<std::string>>(value);
}
template <std::integral T>
requires(!std::same_as<T, bool>) void from_value(const KeyValue& value, T& v) {
  v = static_cast<T>(std::get<std::int64_t>(value));
}
template <class T>
void from_value(const KeyValue& value, std::optional<T>& v) {
  if (std::holds_alternative<std::monostate>(value)) {
    v.reset();
  } else {
    from_value(value, v.emplace());
  }
}

// The type of the key of a member; a Vec3 and three numbers are a vec3.
template <class T>
constexpr KeyType key_type() {
  if constexpr (std::same_as<T, double> || std::same_as<T, std::optional<double>>) {
    return KeyType::number;
  } else if constexpr (std::same_as<T, bool>) {
    return KeyType::boolean;
  } else if constexpr (std::integral<T>) {
    return KeyType::integer;
  } else if constexpr (std::same_as<T, std::string>) {
    return KeyType::text;
  } else if constexpr (std::same_as<T, std::vector<double>>) {
    return KeyType::numbers;
  } else if constexpr (std::same_as<T, std::vector<std::string>>) {
    return KeyType::texts;
  } else {
    return KeyType::vec3;
  }
}

// A key bound to a member of Spec. The modifiers return the key, so that a table reads as a list.
template <class Spec>
struct Key : KeyInfo {
  std::function<KeyValue(const Spec&)> get;
  std::function<void(Spec&, const KeyValue&)> set;
  KeyValue fallback;  // set where the key is absent and the member's own default is not meant

  Key& must_be_given() { return required = true, *this; }
  Key& above(double low) { return range.low = low, range.above = true, *this; }
  Key& at_least(double low) { return range.low = low, range.above = false, *this; }
  Key& up_to(double high) { return range.high = high, *this; }
  Key& or_infinite() { return range.infinite = true, *this; }
  Key& only_for(const std::vector<std::string>& words_of_selector) {
    return owners = words_of_selector, *this;
  }
  Key& else_used(const std::string& text) { return default_text = text, *this; }
  Key& or_else(KeyValue value) { return fallback = std::move(value), *this; }
  Key& not_yet(const std::vector<std::string>& words_planned) {
    return planned = words_planned, *this;
  }
  Key& of_type(KeyType other) { return type = other, *this; }
  Key& file_path() { return path = true, *this; }
  Key& refused_if(std::string (*why)(const KeyValue&)) { return refuse = why, *this; }
};

// A key of the type of its member.
template <class Spec, class T>
Key<Spec> key(const std::string& name, T Spec::*member, const std::string& unit,
              const std::string& meaning) {
  Key<Spec> k;
  k.name = name;
  k.type = key_type<T>();
  k.unit = unit;
  k.meaning = meaning;
  k.get = [member](const Spec& spec) { return to_value(spec.*member); };
  k.set = [member](Spec& spec, const KeyValue& value) { from_value(value, spec.*member); };
  return k;
}

// A key whose words stand for the values of an enumeration.
template <class Spec, class Enum>
Key<Spec> word(const std::string& name, Enum Spec::*member,
               const std::vector<std::pair<std::string, Enum>>& choices,
               const std::string& meaning) {
  Key<Spec> k;
  k.name = name;
  k.type = KeyType::word;
  k.meaning = meaning;
  for (const auto& choice : choices) k.words.push_back(choice.first);
  k.get = [member, choices](const Spec& spec) -> KeyValue {
    for (const auto& [text, value] : choices) {
      if (spec.*member == value) return text;
    }
    return {};
  };
  k.set = [member, choices](Spec& spec, const KeyValue& chosen) {
    for (const auto& [text, value] : choices) {
      if (std::get<std::string>(chosen) == text) spec.*member = value;
    }
  };
  return k;
}

// A table of the mission file without bindings.
struct TableInfo {
  std::string path;  // dotted: "net.thread"; empty: the top of the file
  std::string meaning;
  std::string selector;               // key whose word decides which other keys belong; or empty
  bool list = false;                  // an array of tables, [[path]]
  std::vector<std::string> children;  // tables inside
};

template <class Spec>
struct Table {
  TableInfo info;
  std::vector<Key<Spec>> keys;

  Table(TableInfo table, std::vector<Key<Spec>> its_keys)
      : info(std::move(table)), keys(std::move(its_keys)) {
    const Spec fresh{};
    for (auto& k : keys) {
      const bool absent = std::holds_alternative<std::monostate>(k.fallback);
      if (!k.required) k.standard = absent ? k.get(fresh) : k.fallback;
    }
  }

  // The word of the selector in a spec; empty where the table has no selector.
  std::string selected(const Spec& spec) const {
    for (const auto& k : keys) {
      if (!info.selector.empty() && k.name == info.selector) {
        return std::get<std::string>(k.get(spec));
      }
    }
    return {};
  }

  // The keys that belong to a spec, with their values, in the table's order.
  std::vector<std::pair<const KeyInfo*, KeyValue>> values(const Spec& spec) const {
    std::vector<std::pair<const KeyInfo*, KeyValue>> out;
    const std::string word_selected = selected(spec);
    for (const auto& k : keys) {
      if (k.belongs_to(word_selected)) out.emplace_back(&k, k.get(spec));
    }
    return out;
  }
};

}  // namespace retiarius

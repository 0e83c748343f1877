#include "retiarius/mission/key.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace retiarius {

bool Range::holds(double value) const {
  if (std::isnan(value)) return false;
  if (std::isinf(value)) return infinite && value > 0.0;
  return (above ? value > low : value >= low) && value <= high;
}

std::string Range::text() const {
  const bool has_low = std::isfinite(low);
  const bool has_high = std::isfinite(high);
  if (has_low && has_high) {
    return above ? fmt::format("greater than {} and at most {}", low, high)
                 : fmt::format("from {} to {}", low, high);
  }
  if (has_low) return above ? fmt::format("greater than {}", low) : fmt::format("at least {}", low);
  return has_high ? fmt::format("at most {}", high) : "";
}

bool KeyInfo::belongs_to(const std::string& selected) const {
  return owners.empty() || std::find(owners.begin(), owners.end(), selected) != owners.end();
}

std::string type_text(KeyType type) {
  switch (type) {
    case KeyType::number:
      return "a number";
    case KeyType::integer:
      return "an integer";
    case KeyType::boolean:
      return "true or false";
    case KeyType::text:
      return "a text";
    case KeyType::word:
      return "a word";
    case KeyType::vec3:
      return "a list of three numbers";
    case KeyType::numbers:
      return "a number or a list of numbers";
    case KeyType::texts:
      return "a text or a list of texts";
    case KeyType::node:
      return "the name of a node or its index";
  }
  return {};
}

std::string number_text(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (std::isnan(value)) return "nan";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        out += "\\\"";
        break;
      case '\\':
        out += "\\\\";
        break;
      case '\n':
        out += "\\n";
        break;
      case '\t':
        out += "\\t";
        break;
      case '\r':
        out += "\\r";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
          out += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        } else {
          out += c;
        }
    }
  }
  return out + "\"";
}

namespace {

struct AsText {
  std::string operator()(std::monostate) const { return ""; }
  std::string operator()(bool v) const { return v ? "true" : "false"; }
  std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
  std::string operator()(double v) const { return number_text(v); }
  std::string operator()(const std::string& v) const { return quoted(v); }
  std::string operator()(const std::vector<double>& v) const { return list(v, number_text); }
  std::string operator()(const std::vector<std::string>& v) const { return list(v, quoted); }

  template <class T, class F>
  static std::string list(const std::vector<T>& values, F text) {
    std::vector<std::string> items;
    for (const auto& value : values) items.push_back(text(value));
    if (items.size() == 1) return items.front();
    return fmt::format("[{}]", fmt::join(items, ", "));
  }
};

}  // namespace

std::string value_text(const KeyValue& value) { return std::visit(AsText{}, value); }

}  // namespace retiarius

// Recursive descent over the grammar in trigger.hpp.
#include <cctype>
#include <charconv>

#include <fmt/format.h>

#include "retiarius/mission/key.hpp"
#include "retiarius/mission/nearest.hpp"
#include "retiarius/mission/trigger.hpp"
#include "retiarius/mission/trigger_node.hpp"

namespace retiarius {

class TriggerParser {
 public:
  TriggerParser(const std::string& text, const SourcePlace& place, const std::string& key)
      : text_(text), place_(place), key_(key) {}

  std::shared_ptr<const Trigger::Node> parse() {
    if (peek() == '\0') fail(at_, "a trigger must not be empty, write for example time >= 2.0");
    auto root = list(TriggerKind::any);
    if (peek() != '\0') {
      fail(at_, fmt::format("expected and, or, or the end, found {}", found()));
    }
    return root;
  }

 private:
  using Node = Trigger::Node;

  [[noreturn]] void fail(std::size_t at, const std::string& why) const {
    SourcePlace place = place_;
    if (place.column > 0) place.column += static_cast<int>(at);
    throw InputError(place,
                     fmt::format("{} = {}: at character {}: {}", key_, quoted(text_), at + 1, why));
  }

  // The next character that is not blank; zero at the end.
  char peek() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  std::string name_here() {
    peek();
    std::size_t end = at_;
    while (end < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_')) {
      ++end;
    }
    return text_.substr(at_, end - at_);
  }

  std::string found() {
    if (peek() == '\0') return "the end";
    const std::string name = name_here();
    return fmt::format("\"{}\"", name.empty() ? text_.substr(at_, 1) : name);
  }

  bool accept(const std::string& word) {
    if (name_here() != word) return false;
    at_ += word.size();
    return true;
  }

  // Parts joined by `or` (any) or by `and` (all).
  std::shared_ptr<const Node> list(TriggerKind kind) {
    const bool any = kind == TriggerKind::any;
    auto node = std::make_shared<Node>();
    node->kind = kind;
    do {
      node->parts.push_back(any ? list(TriggerKind::all) : one());
    } while (accept(any ? "or" : "and"));
    return node;
  }

  std::shared_ptr<const Node> one() {
    if (peek() == '(') return group();
    const std::size_t start = at_;
    const std::string name = name_here();
    if (name.empty() || name == "and" || name == "or") {
      fail(start, fmt::format("expected a quantity, a word or (, found {}", found()));
    }
    at_ += name.size();
    auto node = std::make_shared<Node>();
    node->name = known(name, start);
    if (!node->name->flag) {
      node->kind = TriggerKind::comparison;
      node->comparison = comparison(name);
      node->number = number();
    }
    return node;
  }

  std::shared_ptr<const Node> group() {
    constexpr int kDeepest = 100;  // parentheses inside each other
    if (++depth_ > kDeepest) fail(at_, "too many parentheses inside each other");
    const std::size_t open = at_++;
    auto node = list(TriggerKind::any);
    if (peek() != ')') fail(open, "this parenthesis is not closed");
    ++at_;
    --depth_;
    return node;
  }

  const TriggerName* known(const std::string& name, std::size_t start) const {
    std::vector<std::string> names;
    for (const TriggerName& candidate : trigger_names()) {
      if (candidate.name == name) return &candidate;
      names.push_back(candidate.name);
    }
    fail(start, fmt::format("unknown name {}{}", name, suggestion(name, names)));
  }

  Comparison comparison(const std::string& name) {
    const char first = peek();
    if (first != '>' && first != '<') {
      fail(at_, fmt::format("expected >=, >, <= or < after {}, found {}", name, found()));
    }
    ++at_;
    const bool or_equal = at_ < text_.size() && text_[at_] == '=';
    if (or_equal) ++at_;
    if (first == '>') return or_equal ? Comparison::at_least : Comparison::above;
    return or_equal ? Comparison::at_most : Comparison::below;
  }

  double number() {
    peek();
    const std::size_t start = at_;
    std::size_t digits = at_;
    if (digits < text_.size() && (text_[digits] == '+' || text_[digits] == '-')) ++digits;
    const bool starts =
        digits < text_.size() &&
        (std::isdigit(static_cast<unsigned char>(text_[digits])) || text_[digits] == '.');
    double value = 0.0;
    const char* const end = text_.data() + text_.size();
    const auto result = std::from_chars(text_.data() + digits, end, value);
    const bool whole = result.ptr == end || std::isspace(static_cast<unsigned char>(*result.ptr)) ||
                       *result.ptr == ')';
    if (starts && result.ec == std::errc::result_out_of_range) fail(start, "number out of range");
    if (!starts || result.ec != std::errc() || !whole) {
      fail(start, fmt::format("expected a number, found {}", found()));
    }
    at_ = static_cast<std::size_t>(result.ptr - text_.data());
    return text_[start] == '-' ? -value : value;
  }

  const std::string& text_;
  SourcePlace place_;
  const std::string& key_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

Trigger Trigger::parse(const std::string& text, const SourcePlace& place, const std::string& key) {
  Trigger trigger;
  trigger.text_ = text;
  trigger.root_ = TriggerParser(text, place, key).parse();
  return trigger;
}

}  // namespace retiarius

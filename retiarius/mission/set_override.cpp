#include "retiarius/mission/set_override.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "retiarius/mission/nearest.hpp"
#include "retiarius/mission/schema.hpp"
#include "retiarius/mission/table_source.hpp"

namespace retiarius {

namespace {

struct Step {
  std::string name;
  std::optional<std::size_t> index;
};

class Override {
 public:
  explicit Override(const std::string& text) : source_(kOverrideMark + text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) fail("expected path=value");
    path_ = trimmed(text.substr(0, equals));
    value_ = trimmed(text.substr(equals + 1));
    split();
  }

  void apply(toml::table& root) const {
    toml::table* table = &root;
    std::string plain;  // dotted, without brackets
    for (std::size_t i = 0; i + 1 < steps_.size(); ++i) {
      const std::string parent = std::exchange(plain, join(plain, steps_[i].name));
      check_table(parent, plain, steps_[i].name);
      table = inside(*table, steps_[i], find_table(plain)->info->list, plain);
    }
    const Step& last = steps_.back();
    if (last.index) {
      put_element(*table, plain, last);
    } else {
      put(*table, last.name, parse_value(plain, last.name));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(SourcePlace{source_, 0, 0}, why);
  }

  static std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
  }

  static std::string join(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
  }

  void split() {
    std::size_t start = 0;
    while (true) {
      const std::size_t dot = path_.find('.', start);
      add_step(path_.substr(start, dot == std::string::npos ? dot : dot - start));
      if (dot == std::string::npos) return;
      start = dot + 1;
    }
  }

  void add_step(const std::string& part) {
    Step step{part, std::nullopt};
    const auto open = part.find('[');
    if (open != std::string::npos) {
      const std::string digits =
          part.back() == ']' ? part.substr(open + 1, part.size() - open - 2) : "";
      const bool number = !digits.empty() && digits.size() < 7 &&
                          std::all_of(digits.begin(), digits.end(),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
      if (!number) fail(fmt::format("\"{}\" is not a name with an index, as in phase[0]", part));
      step = {part.substr(0, open), std::stoul(digits)};
    }
    if (step.name.empty()) fail("the path has an empty name");
    steps_.push_back(step);
  }

  // Refuses names of tables that do not exist, rather than making them.
  void check_table(const std::string& parent, const std::string& path,
                   const std::string& name) const {
    if (find_table(path)) return;
    std::vector<std::string> names;
    if (const TableView* table = find_table(parent)) names = table->info->children;
    for (const KeyInfo* k : find_table(parent)->keys) {
      if (k->name == name) fail(fmt::format("{} is not a table", path));
    }
    fail(fmt::format("unknown table {}{}", path, names.empty() ? "" : suggestion(name, names)));
  }

  // The table that a step leads to, made where it is missing.
  toml::table* inside(toml::table& table, const Step& step, bool list,
                      const std::string& path) const {
    toml::node* node = table.get(step.name);
    if (!list) {
      if (step.index) fail(fmt::format("{} is one table, write it without brackets", path));
      if (!node) node = put(table, step.name, make("{}"));
    } else if (step.name == "target") {
      if (!node && step.index.value_or(0) == 0) node = put(table, step.name, make("{}"));
      if (node && node->is_array()) return element(*node, Step{step.name, step.index.value_or(0)});
      if (step.index.value_or(0) > 0) fail("there is no list of targets, [[target]], to index");
    } else {
      if (!step.index) fail(fmt::format("{} is a list of tables, write {}[0]", path, path));
      if (!node) node = put(table, step.name, make("[]"));
      return element(*node, step);
    }
    if (!node->is_table()) fail(fmt::format("{} is not a table in the file", path));
    return node->as_table();
  }

  toml::table* element(toml::node& node, const Step& step) const {
    toml::array* array = node.as_array();
    if (!array) fail(fmt::format("{} is not a list of tables in the file", step.name));
    const std::size_t index = *step.index;
    if (index > array->size()) {
      fail(fmt::format("{}[{}] does not exist: there are {}", step.name, index, array->size()));
    }
    if (index == array->size()) {
      toml::table made = make("{}");
      std::move(*made.get("value")).visit([&](auto&& n) { array->push_back(std::move(n)); });
    }
    toml::table* found = array->get_as<toml::table>(index);
    if (!found) fail(fmt::format("{}[{}] is not a table in the file", step.name, index));
    return found;
  }

  // A document with one key, `value`, whose source is this override.
  toml::table make(const std::string& toml_value) const {
    return toml::parse("value = " + toml_value + "\n", source_);
  }

  static toml::node* put(toml::table& table, const std::string& name, toml::table document) {
    toml::node* made = nullptr;
    std::move(*document.get("value")).visit([&](auto&& n) {
      made = &table.insert_or_assign(name, std::move(n)).first->second;
    });
    return made;
  }

  // One number of a list that the file gives, or that holds by default.
  void put_element(toml::table& table, const std::string& plain, const Step& last) const {
    const std::string name = join(plain, last.name);
    const KeyInfo* key = nullptr;
    for (const KeyInfo* k : find_table(plain)->keys) {
      if (k->name == last.name) key = k;
    }
    if (!key) {
      parse_value(plain, last.name);  // names the unknown key
      fail(fmt::format("{} is a table, not a list of numbers", name));
    }
    if (key->type != KeyType::vec3 && key->type != KeyType::numbers) {
      fail(fmt::format("{} is no list of numbers; write it without brackets", name));
    }
    std::vector<double> list = present_list(table, *key, name);
    if (*last.index >= list.size()) {
      fail(fmt::format("{}[{}] does not exist: there are {}", name, *last.index, list.size()));
    }
    const toml::table document = parse_value(plain, last.name);
    const auto number = document.get("value")->value<double>();
    if (!document.get("value")->is_number()) fail("the value must be a number");
    list[*last.index] = *number;
    std::vector<std::string> texts;
    for (const double item : list) texts.push_back(number_text(item));
    put(table, last.name, make(fmt::format("[{}]", fmt::join(texts, ", "))));
  }

  std::vector<double> present_list(const toml::table& table, const KeyInfo& key,
                                   const std::string& name) const {
    const toml::node* node = table.get(key.name);
    if (!node) {
      const auto* standard = std::get_if<std::vector<double>>(&key.standard);
      if (!standard) fail(fmt::format("{} is not given, so there is no list to index", name));
      return *standard;
    }
    const toml::array* array = node->as_array();
    if (!array) fail(fmt::format("{} is one number in the file; give it whole", name));
    std::vector<double> list;
    for (const toml::node& item : *array) {
      if (!item.is_number()) fail(fmt::format("{} is not a list of numbers in the file", name));
      list.push_back(*item.value<double>());
    }
    return list;
  }

  // The TOML value, or the bare text where the key is one.
  toml::table parse_value(const std::string& table, const std::string& name) const {
    const TableView& view = *find_table(table);
    bool textual = false, list = false;
    std::vector<std::string> names = view.info->children;
    for (const KeyInfo* k : view.keys) {
      names.push_back(k->name);
      if (k->name != name) continue;
      textual = k->type == KeyType::text || k->type == KeyType::word || k->type == KeyType::texts ||
                k->type == KeyType::node;
      list = k->type == KeyType::texts;
    }
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      fail(fmt::format("unknown key {}{}", join(table, name), suggestion(name, names)));
    }
    if (value_.empty()) fail("the value is missing");
    try {
      toml::table document = make(value_);
      if (document.size() != 1) fail("the value must be one TOML value");
      const toml::node& node = *document.get("value");
      if (!textual || node.is_string() || (list && node.is_array())) return document;
    } catch (const toml::parse_error& error) {
      if (!textual) {
        fail(fmt::format("\"{}\" is not a TOML value: {}", value_, error.description()));
      }
    }
    try {
      return make(quoted(value_));
    } catch (const toml::parse_error& error) {
      fail(fmt::format("the value is not a text: {}", error.description()));
    }
  }

  std::string source_;
  std::string path_;
  std::string value_;
  std::vector<Step> steps_;
};

}  // namespace

void apply_override(toml::table& root, const std::string& override_text) {
  Override(override_text).apply(root);
}

}  // namespace retiarius

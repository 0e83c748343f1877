// Every key of every table: default, accepted values, wrong types, values out of range. The cases
// come from the schema itself; a mission for each pattern, shape and kind of phase carries them.
#include "retiarius/mission/schema.hpp"

#include <cmath>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "retiarius/mission/writer.hpp"
#include "texts.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;
using Lines = std::vector<std::string>;

const std::string kAnyFile = std::string(RETIARIUS_SOURCE_DIR) + "/CMakeLists.txt";

std::string thread_text() {
  return "[net.thread]\nyoung_modulus = 1.0e6\ndensity = 1000.0\nradius = 0.01\n";
}

std::string net_text(const std::string& pattern) {
  if (pattern == "file") return fmt::format("[net]\npattern = \"file\"\nfile = \"{}\"\n", kAnyFile);
  return fmt::format("[net]\npattern = \"{}\"\nside = 2.0\nmesh = 0.5\n", pattern);
}

std::string target_text(const std::string& shape) {
  std::string text = fmt::format("[[target]]\nshape = \"{}\"\n", shape);
  const std::set<std::string> round = {"sphere", "cylinder", "capsule", "cone"};
  if (round.count(shape) > 0) text += "radius = 0.7\n";
  if (round.count(shape) > 0 && shape != "sphere") text += "length = 1.5\n";
  if (shape == "box") text += "size = [3.0, 1.0, 2.0]\n";
  if (shape == "mesh") text += fmt::format("file = \"{}\"\n", kAnyFile);
  if (shape == "plane") return text + "motion = \"fixed\"\n";
  return text + (shape == "box" ? "density = 9.0\n" : "mass = 9.0\n");
}

std::string phase_text(const std::string& kind) {
  std::string text = fmt::format("[[phase]]\nkind = \"{}\"\nuntil = \"time >= 1\"\n", kind);
  if (kind == "shoot") text += "speed = 5.0\n";
  if (kind == "fold") text += "duration = 3.0\ngrip_spacing = 0.3\n";
  text += "[[phase.move]]\nnodes = \"center\"\n";
  if (kind == "spread") return text + "displacement = [0.0, 0.0, 1.0]\nduration = 1.0\n";
  return text + "velocity = [0.0, 0.0, 1.0]\n";
}

const KeyInfo* selector(const char* table) {
  const TableView* view = find_table(table);
  for (const KeyInfo* k : view->keys) {
    if (k->name == view->info->selector) return k;
  }
  return nullptr;
}

// A resolved mission for each word of each selector.
Lines resolved_missions() {
  Lines out;
  const std::string probe = "[[probe]]\nnode = \"center\"\n";
  const auto add = [&](const std::string& net, const std::string& target,
                       const std::string& phase) {
    const std::string text =
        net_text(net) + thread_text() + target_text(target) + phase_text(phase) + probe;
    out.push_back(to_toml(parse_mission(text)));
  };
  for (const auto& word : selector("net")->words) add(word, "sphere", "free");
  for (const auto& word : selector("target")->words) add("hexagon", word, "free");
  for (const auto& word : selector("phase")->words) add("square", "sphere", word);
  return out;
}

Lines lines_of(const std::string& text) {
  Lines out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

std::string joined(const Lines& lines) {
  std::string out;
  for (const auto& line : lines) out += line + "\n";
  return out;
}

// The line on which a key of a table stands in a resolved mission; -1 if it does not.
int line_of(const Lines& lines, const TableInfo& table, const std::string& key) {
  const std::string heading = table.list ? "[[" + table.path + "]]" : "[" + table.path + "]";
  bool inside = table.path.empty();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!lines[i].empty() && lines[i][0] == '[') inside = lines[i] == heading;
    const bool here =
        lines[i].rfind(key + " = ", 0) == 0 || lines[i].rfind("# " + key + ": ", 0) == 0;
    if (inside && here) return static_cast<int>(i);
  }
  return -1;
}

// The name of a key in messages; every list of tables in the resolved missions has one element.
std::string full_name(const TableInfo& table, const std::string& key) {
  if (table.path.empty()) return key;
  if (table.path == "phase.move") return "phase[0].move[0]." + key;
  return table.path + (table.list ? "[0]." : ".") + key;
}

Lines wrong_types(const KeyInfo& key) {
  switch (key.type) {
    case KeyType::number:
      return {"\"x\"", "true", "[1.0, 2.0]", "1979-05-27"};
    case KeyType::integer:
      return {"1.5", "\"x\"", "[1]"};
    case KeyType::boolean:
      return {"1", "\"true\""};
    case KeyType::text:
      return {"5", "true", "[\"a\"]"};
    case KeyType::word:
      return {"5", "\"nonsense\"", "\"\""};
    case KeyType::vec3:
      return {"1.0", "[1.0, 2.0]", "[1.0, 2.0, 3.0, 4.0]", "[1.0, 2.0, \"x\"]"};
    case KeyType::numbers:
      return {"\"x\"", "[]", "[1.0, \"a\"]", "[[1.0]]"};
    case KeyType::texts:
      return {"1.5", "[]", "true", "[\"a\", 1.5]", "\"\"", "-1"};
    case KeyType::node:
      return {"1.5", "true", "-1", "\"\""};
  }
  return {};
}

Lines out_of_range(const KeyInfo& key) {
  Lines out;
  const bool list = key.type == KeyType::vec3 || key.type == KeyType::numbers;
  const auto add = [&](double value) {
    const bool whole = key.type == KeyType::integer;
    const std::string text =
        whole ? std::to_string(static_cast<long long>(value)) : number_text(value);
    out.push_back(list ? fmt::format("[1.0, 1.0, {}]", text) : text);
  };
  if (std::isfinite(key.range.low)) add(key.range.low - 1.0);
  if (std::isfinite(key.range.low) && key.range.above) add(key.range.low);
  if (std::isfinite(key.range.high)) add(key.range.high + 1.0);
  if (list || key.type == KeyType::number) {
    if (!key.range.infinite) add(kInfinity);
    add(-kInfinity);
    add(std::nan(""));
  }
  return out;
}

// Values of which at least one must be accepted and kept; other than the defaults.
Lines candidates(const KeyInfo& key) {
  Lines words;
  for (const auto& word : key.words) words.push_back(quoted(word));
  switch (key.type) {
    case KeyType::number:
      return {"0.015", "0.05", "0.5", "7.5"};
    case KeyType::integer:
      return {"5", "1"};
    case KeyType::boolean:
      return {"true", "false"};
    case KeyType::text:
      return {"\"other\"", "\"time >= 7\"", quoted(RETIARIUS_SOURCE_DIR)};
    case KeyType::word:
      return words;
    case KeyType::vec3:
      return {"[1.0, 1.5, 2.0]", "[0.0, 0.0, 0.0]"};
    case KeyType::numbers:
      return {"4.5"};
    case KeyType::texts:
      return {"[\"corner0\", \"corner1\"]"};
    case KeyType::node:
      return {"\"corner1\""};
  }
  return {};
}

template <class F>
void for_each_key(F visit) {
  for (const std::string& mission : resolved_missions()) {
    const Lines lines = lines_of(mission);
    for (const TableView& table : schema_tables()) {
      for (const KeyInfo* k : table.keys) {
        const int line = line_of(lines, *table.info, k->name);
        if (line < 0) continue;
        // Keys of one name differ by their owners: the one that belongs here is meant.
        std::string word;
        if (!table.info->selector.empty()) {
          const auto& text =
              lines[static_cast<std::size_t>(line_of(lines, *table.info, table.info->selector))];
          word = text.substr(text.find('"') + 1, text.rfind('"') - text.find('"') - 1);
        }
        if (k->belongs_to(word)) visit(lines, line, *table.info, *k);
      }
    }
  }
}

TEST(Schema, EveryKeyStandsInAResolvedMission) {
  std::set<const KeyInfo*> seen;
  for_each_key([&](const Lines&, int, const TableInfo&, const KeyInfo& k) { seen.insert(&k); });
  for (const TableView& table : schema_tables()) {
    for (const KeyInfo* k : table.keys) {
      EXPECT_EQ(seen.count(k), 1u) << table.info->path << "." << k->name;
    }
  }
}

TEST(Schema, WrongTypesAreErrorsAtTheirLine) {
  int cases = 0;
  for_each_key([&](const Lines& lines, int line, const TableInfo& table, const KeyInfo& k) {
    for (const std::string& value : wrong_types(k)) {
      Lines changed = lines;
      changed[static_cast<std::size_t>(line)] = k.name + " = " + value;
      const std::string error = error_of(joined(changed));
      EXPECT_THAT(error, HasSubstr(fmt::format("m.toml:{}:{}: ", line + 1, k.name.size() + 4)));
      EXPECT_THAT(error, HasSubstr(full_name(table, k.name) + " = "));
      EXPECT_THAT(error, HasSubstr("must"));
      ++cases;
    }
  });
  EXPECT_GT(cases, 1000);
}

TEST(Schema, ValuesOutOfRangeAreErrorsAtTheirLine) {
  int cases = 0;
  for_each_key([&](const Lines& lines, int line, const TableInfo& table, const KeyInfo& k) {
    for (const std::string& value : out_of_range(k)) {
      Lines changed = lines;
      changed[static_cast<std::size_t>(line)] = k.name + " = " + value;
      const std::string error = error_of(joined(changed));
      EXPECT_THAT(error, HasSubstr(fmt::format("m.toml:{}:{}: ", line + 1, k.name.size() + 4)))
          << value;
      EXPECT_THAT(error, HasSubstr(full_name(table, k.name) + " = "));
      EXPECT_THAT(error, HasSubstr("must be"));
      ++cases;
    }
  });
  EXPECT_GT(cases, 1000);
}

// An accepted value comes back, and it changes nothing else: no two keys share a member.
TEST(Schema, AcceptedValuesAreKeptAndChangeOneLine) {
  std::set<const KeyInfo*> changeable;
  for_each_key([&](const Lines& lines, int line, const TableInfo& table, const KeyInfo& k) {
    if (k.name == table.selector) return;
    for (const std::string& value : candidates(k)) {
      Lines changed = lines;
      const auto at = static_cast<std::size_t>(line);
      changed[at] = k.name + " = " + value + (k.unit.empty() ? "" : "  # " + k.unit);
      if (changed[at] == lines[at] || !error_of(joined(changed)).empty()) continue;
      EXPECT_EQ(to_toml(parse_mission(joined(changed))), joined(changed));
      changeable.insert(&k);
    }
  });
  for (const TableView& table : schema_tables()) {
    for (const KeyInfo* k : table.keys) {
      const bool selects = k->name == table.info->selector;
      const bool constant = k->name == "format";
      EXPECT_EQ(changeable.count(k), selects || constant ? 0u : 1u)
          << table.info->path << "." << k->name;
    }
  }
}

// What the documentation calls the default is what an absent key gives.
TEST(Schema, AbsentKeysHaveTheDocumentedDefault) {
  int cases = 0;
  for_each_key([&](const Lines& lines, int line, const TableInfo& table, const KeyInfo& k) {
    const std::string name = full_name(table, k.name);
    Lines changed = lines;
    changed[static_cast<std::size_t>(line)] = "";
    const std::string error = error_of(joined(changed));
    if (k.required) {
      EXPECT_THAT(error, HasSubstr(name + " is missing: give "));
      ++cases;
    } else if (error.empty() && k.default_text.empty()) {
      const Lines again = lines_of(to_toml(parse_mission(joined(changed))));
      const std::string expected = fmt::format("{} = {}", k.name, value_text(k.standard));
      EXPECT_THAT(again[static_cast<std::size_t>(line)], testing::StartsWith(expected)) << name;
      ++cases;
    }
  });
  EXPECT_GT(cases, 300);
}

TEST(Schema, KeysOfAnotherWordAreErrors) {
  int cases = 0;
  for (const std::string& mission : resolved_missions()) {
    const Lines lines = lines_of(mission);
    for (const TableView& table : schema_tables()) {
      if (table.info->selector.empty()) continue;
      const int at = line_of(lines, *table.info, table.info->selector);
      for (const KeyInfo* k : table.keys) {
        if (line_of(lines, *table.info, k->name) >= 0) continue;
        Lines changed = lines;
        changed.insert(changed.begin() + at + 1, k->name + " = 1");
        const std::string error = error_of(joined(changed));
        EXPECT_THAT(error,
                    HasSubstr(fmt::format("m.toml:{}:1: {} belongs to {} ", at + 2,
                                          full_name(*table.info, k->name), table.info->selector)));
        ++cases;
      }
    }
  }
  EXPECT_GT(cases, 100);
}

TEST(Schema, EveryKeyHasAMeaningAndOwnersThatExist) {
  for (const TableView& table : schema_tables()) {
    const KeyInfo* chooser = selector(table.info->path.c_str());
    for (const KeyInfo* k : table.keys) {
      EXPECT_FALSE(k->meaning.empty()) << k->name;
      for (const auto& owner : k->owners) {
        ASSERT_NE(chooser, nullptr) << k->name;
        EXPECT_THAT(chooser->words, testing::Contains(owner)) << k->name;
      }
    }
  }
}

TEST(Schema, FindsTablesByPath) {
  EXPECT_EQ(find_table("net.thread")->info->path, "net.thread");
  EXPECT_EQ(find_table("phase.contact")->info->path, "contact");
  EXPECT_EQ(find_table("net.threads"), nullptr);
}

}  // namespace
}  // namespace retiarius

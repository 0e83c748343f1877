// docs/mission-file.md from the schema.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "retiarius/mission/schema.hpp"
#include "retiarius/mission/trigger.hpp"
#include "retiarius/mission/writer.hpp"

namespace retiarius {

namespace {

std::string default_of(const KeyInfo& key) {
  if (key.required) return "**required**";
  const std::string value = value_text(key.standard);
  const bool absent = value.empty() || value == "\"\"";
  if (absent) return key.default_text.empty() ? "none" : key.default_text;
  return "`" + value + "`";
}

std::string type_of(const KeyInfo& key) {
  if (key.type != KeyType::word) return type_text(key.type);
  std::vector<std::string> words;
  for (const auto& word : key.words) words.push_back("`\"" + word + "\"`");
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string row(const TableInfo& table, const KeyInfo& key) {
  std::string meaning = key.meaning;
  const std::string range = key.range.text();
  if (!range.empty()) meaning += fmt::format("; {}", range);
  if (key.path) meaning += "; relative to the mission file's folder";
  if (!key.owners.empty()) {
    meaning += fmt::format(" *({} {})*", table.selector, fmt::join(key.owners, ", "));
  }
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, type_of(key), key.unit,
                     default_of(key), meaning);
}

std::string heading(const TableInfo& table) {
  if (table.path.empty()) return "## Top of the file";
  if (table.path == "target") return "## `[target]`, `[[target]]`";
  return table.list ? fmt::format("## `[[{}]]`", table.path) : fmt::format("## `[{}]`", table.path);
}

constexpr const char* kOpening = R"(# The mission file

<!-- Generated from the schema in retiarius/mission; do not edit. -->

One run is described by one TOML file. Units are SI, angles are radians except where a key ends in
`_deg`. Unknown keys, wrong types and impossible values are errors that name file, line and column;
so are keys that do not belong to the pattern, shape or kind of phase chosen. Every number must be
finite. Keys marked *(pattern ...)*, *(shape ...)* or *(kind ...)* belong to these alone.

The net lies in its xy-plane with its centre at the origin, sides along the axes. Named nodes are
`center`, the knot nearest the centroid, and `corner0`, `corner1`, ..., counter-clockwise from +x
(square: from the quadrant of +x and +y) seen from +z; groups are `corners` and `perimeter`. Where
nodes are named, an index counting from 0 will do as well.

)";

constexpr const char* kTriggers = R"(## Triggers

`until` is tested after every accepted step. It compares quantities with numbers (`>=`, `>`, `<=`,
`<`) and knows words that are true or false; `and` binds tighter than `or`, parentheses group:
`contact or time >= 3.0 and (widest or distance > 12)`. Times within 1e-9 of the number, relative to
it above 1 s, count as equal to it.

| name | unit | meaning |
|---|---|---|
)";

constexpr const char* kOverrides = R"(
## Overrides

`--set path=value` replaces one value before the mission is checked. Paths are dotted, lists of
tables take zero-based brackets, values are TOML; texts and words may stand without quotes:

    --set net.thread.radius=0.004 --set 'phase[0].half_angle_deg=30' --set contact.method=none

`target` and `target[0]` are the same. Tables that the file lacks are made. Brackets after the key
of a list of numbers stand for one of them: `--set 'target.position[0]=0.3'`.

## The resolved mission

Each run leaves `resolved.toml`: the mission with every default and override filled in, paths made
absolute. It is a mission file itself.

## An example

`retiarius new NAME` writes it:

)";

}  // namespace

std::string mission_file_markdown() {
  std::string out = kOpening;
  for (const TableView& table : schema_tables()) {
    out += fmt::format("{}\n\n{}\n\n", heading(*table.info), table.info->meaning);
    out += "| key | value | unit | default | meaning |\n|---|---|---|---|---|\n";
    for (const KeyInfo* k : table.keys) out += row(*table.info, *k);
    out += "\n";
  }
  out += kTriggers;
  for (const TriggerName& name : trigger_names()) {
    out += fmt::format("| `{}` | {} | {} |\n", name.name, name.flag ? "true or false" : name.unit,
                       name.meaning);
  }
  return out + kOverrides + "```toml\n" + starter_mission("first") + "```\n";
}

}  // namespace retiarius

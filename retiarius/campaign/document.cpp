// docs/campaign-file.md from the schema.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "retiarius/campaign/schema.hpp"

namespace retiarius {

namespace {

constexpr const char* kOpening = R"(# The campaign file

<!-- Generated from the schema in retiarius/campaign; do not edit. -->

A campaign is many runs of one mission with varied or random inputs. It is one TOML file beside
[the mission's](mission-file.md); `retiarius campaign` reads it. Unknown keys, wrong types and
impossible values are errors that name file, line and column. Keys marked *(design ...)*,
*(distribution ...)* or *(what ...)* belong to these alone.

)";

constexpr const char* kClosing = R"(## What is the same, always

The inputs and the seed of a run follow from the campaign file and the run's id alone: not from who
does it, when, or after which other. So every engine gives the same rows, and any run can be repeated
by itself.

Design `saltelli`: with k inputs, run `block (k + 2) + j` is, for j = 0, a row of the matrix A, for
j = 1 the same row of B, and for j = 2 + i the row of A with column i taken from B. A and B are the
halves of one scrambled Sobol' sequence of 2 k dimensions; the rows of a block share their seed.

## An example

`missions/campaigns/aim-and-spin.toml`.
)";

std::string type_of(const KeyInfo& key) {
  if (key.type != KeyType::word) return type_text(key.type);
  std::vector<std::string> words;
  for (const auto& word : key.words) words.push_back("`\"" + word + "\"`");
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string default_of(const KeyInfo& key) {
  if (key.required) return "**required**";
  const std::string value = value_text(key.standard);
  const bool absent = value.empty() || value == "\"\"" || value == "[]";
  if (absent) return key.default_text.empty() ? "none" : key.default_text;
  return "`" + value + "`";
}

template <class Spec>
std::string section(const Table<Spec>& table) {
  const TableInfo& info = table.info;
  std::string out = info.path.empty() ? "## Top of the file"
                    : info.list       ? fmt::format("## `[[{}]]`", info.path)
                                      : fmt::format("## `[{}]`", info.path);
  out +=
      fmt::format("\n\n{}\n\n| key | value | unit | default | meaning |\n|---|---|---|---|---|\n",
                  info.meaning);
  for (const auto& key : table.keys) {
    std::string meaning = key.meaning;
    if (const std::string range = key.range.text(); !range.empty()) meaning += "; " + range;
    if (key.path) meaning += "; relative to the campaign file's folder";
    if (!key.owners.empty())
      meaning += fmt::format(" *({} {})*", info.selector, fmt::join(key.owners, ", "));
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, type_of(key), key.unit,
                       default_of(key), meaning);
  }
  return out + "\n";
}

}  // namespace

std::string campaign_file_markdown() {
  return kOpening + section(campaign_table()) + section(plan_table()) + section(variable_table()) +
         section(group_table()) + section(keep_table()) + section(limit_table()) +
         section(stop_table()) + kClosing;
}

}  // namespace retiarius

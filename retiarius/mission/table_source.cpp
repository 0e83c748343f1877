#include "retiarius/mission/table_source.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "retiarius/mission/nearest.hpp"
#include "retiarius/mission/read_value.hpp"

namespace retiarius {

SourcePlace place_of(const toml::source_region& region, const std::string& file) {
  if (region.path && region.path->rfind(kOverrideMark, 0) == 0) return {*region.path, 0, 0};
  return {file, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

namespace {

bool is_override(const SourcePlace& place) { return place.file.rfind(kOverrideMark, 0) == 0; }

// Keys that an override made have no place of their own; their value has.
SourcePlace place_of_key(const toml::key& key, const toml::node& node, const std::string& file) {
  const bool placed = key.source().begin.line > 0;
  return place_of(placed ? key.source() : node.source(), file);
}

}  // namespace

TableSource::TableSource(const toml::table& table, std::string path, SourcePlace place,
                         Places& places)
    : table_(&table), path_(std::move(path)), place_(std::move(place)), places_(&places) {
  places_->set(path_, place_);
  const std::string file = places_->of("").file;
  for (const auto& [name, node] : table) {
    places_->set(full(std::string(name.str())), place_of(node.source(), file));
  }
}

std::string TableSource::selected(const TableInfo& info,
                                  const std::vector<const KeyInfo*>& keys) const {
  if (info.selector.empty()) return {};
  for (const KeyInfo* k : keys) {
    if (k->name != info.selector) continue;
    if (!has(k->name)) missing(*k);
    return std::get<std::string>(value(*k));
  }
  return {};
}

void TableSource::check_names(const TableInfo& info,
                              const std::vector<const KeyInfo*>& keys) const {
  std::vector<std::string> names = info.children;
  for (const KeyInfo* k : keys) {
    if (std::find(names.begin(), names.end(), k->name) == names.end()) names.push_back(k->name);
  }
  const std::string file = places_->of("").file;
  for (const auto& [name, node] : *table_) {
    const std::string text(name.str());
    if (std::find(names.begin(), names.end(), text) != names.end()) continue;
    const std::string what = fmt::format("unknown key {}", full(text));
    throw InputError(place_of_key(name, node, file), what + suggestion(text, names));
  }
  const std::string word = selected(info, keys);
  for (const auto& [name, node] : *table_) {
    std::vector<std::string> owners;
    bool known = false, belongs = false;
    for (const KeyInfo* k : keys) {
      if (k->name != name.str()) continue;
      known = true;
      belongs = belongs || k->belongs_to(word);
      owners.insert(owners.end(), k->owners.begin(), k->owners.end());
    }
    if (!known || belongs) continue;
    throw InputError(place_of_key(name, node, file),
                     fmt::format("{} belongs to {} {}, not {}", full(std::string(name.str())),
                                 info.selector, fmt::join(owners, ", "), word));
  }
}

KeyValue TableSource::value(const KeyInfo& key) const {
  return read_value(*table_->get(key.name), key, full(key.name), places_->of(full(key.name)));
}

void TableSource::missing(const KeyInfo& key) const {
  std::string what = fmt::format("{} is missing: give {}", full(key.name), type_text(key.type));
  if (!key.words.empty())
    what = fmt::format("{} is missing: give one of {}", full(key.name), fmt::join(key.words, ", "));
  if (!key.unit.empty()) what += fmt::format(" in {}", key.unit);
  throw InputError(place_, fmt::format("{} ({})", what, key.meaning));
}

std::optional<TableSource> TableSource::table(const std::string& name) const {
  const toml::node* node = table_->get(name);
  if (!node) return std::nullopt;
  const SourcePlace place = places_->of(full(name));
  if (!node->is_table()) {
    throw InputError(place, fmt::format("{} must be a table: write [{}]", full(name), full(name)));
  }
  return TableSource(*node->as_table(), full(name), place, *places_);
}

std::vector<TableSource> TableSource::tables(const std::string& name, bool single_allowed) const {
  std::vector<TableSource> out;
  const toml::node* node = table_->get(name);
  if (!node) return out;
  const SourcePlace place = places_->of(full(name));
  if (const toml::table* single = node->as_table(); single && single_allowed) {
    out.emplace_back(*single, full(name), place, *places_);
    return out;
  }
  const toml::array* array = node->as_array();
  if (!array || !std::all_of(array->begin(), array->end(),
                             [](const toml::node& item) { return item.is_table(); })) {
    throw InputError(place, fmt::format("{} must be a list of tables: write [[{}]]", full(name),
                                        path_.empty() ? name : "phase." + name));
  }
  const std::string file = places_->of("").file;
  for (std::size_t i = 0; i < array->size(); ++i) {
    const toml::table& item = *array->get_as<toml::table>(i);
    SourcePlace item_place = place_of(item.source(), file);
    if (item_place.line == 0 && !is_override(item_place)) item_place = place;
    out.emplace_back(item, fmt::format("{}[{}]", full(name), i), item_place, *places_);
  }
  return out;
}

}  // namespace retiarius

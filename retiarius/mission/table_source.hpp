// One table of a mission or campaign file, from which the keys of a schema table are read. Only
// sources of the library include it, for it shows the TOML library.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "retiarius/mission/key.hpp"
#include "retiarius/mission/places.hpp"

namespace retiarius {

// Overrides carry this at the start of their source's name, so that messages name them.
inline constexpr const char* kOverrideMark = "--set ";

// Line and column of a node; the text of the override alone for what --set gave.
SourcePlace place_of(const toml::source_region& region, const std::string& file);

class TableSource {
 public:
  // `path` is the table's name in messages ("phase[1]"); `places` learns where each key stands.
  TableSource(const toml::table& table, std::string path, SourcePlace place, Places& places);

  // Reads the keys into spec. Throws InputError for unknown keys, keys of another selector's word,
  // missing ones, wrong types and values out of range.
  template <class Spec>
  void read(const Table<Spec>& schema, Spec& spec) const;

  // The table inside; none if it is not there.
  std::optional<TableSource> table(const std::string& name) const;

  // The tables of an array of tables inside; a single [name] counts as one where allowed.
  std::vector<TableSource> tables(const std::string& name, bool single_allowed) const;

  const std::string& path() const { return path_; }
  const SourcePlace& place() const { return place_; }

 private:
  std::string full(const std::string& name) const {
    return path_.empty() ? name : path_ + "." + name;
  }
  bool has(const std::string& name) const { return table_->contains(name); }
  std::string selected(const TableInfo& info, const std::vector<const KeyInfo*>& keys) const;
  void check_names(const TableInfo& info, const std::vector<const KeyInfo*>& keys) const;
  KeyValue value(const KeyInfo& key) const;
  [[noreturn]] void missing(const KeyInfo& key) const;

  const toml::table* table_;
  std::string path_;
  SourcePlace place_;
  Places* places_;
};

template <class Spec>
void TableSource::read(const Table<Spec>& schema, Spec& spec) const {
  std::vector<const KeyInfo*> infos;
  for (const auto& k : schema.keys) infos.push_back(&k);
  check_names(schema.info, infos);
  const std::string word = selected(schema.info, infos);
  for (const auto& k : schema.keys) {
    if (!k.belongs_to(word)) continue;
    if (has(k.name)) {
      k.set(spec, value(k));
    } else if (k.required) {
      missing(k);
    } else if (!std::holds_alternative<std::monostate>(k.fallback)) {
      k.set(spec, k.fallback);
    }
  }
}

}  // namespace retiarius

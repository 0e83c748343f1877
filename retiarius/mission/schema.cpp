#include "retiarius/mission/schema.hpp"

#include <fmt/format.h>

namespace retiarius {

const Table<Mission>& mission_table() {
  static const Table<Mission> table = [] {
    Key<Mission> format;
    format.name = "format";
    format.type = KeyType::integer;
    format.meaning = "version of the mission file's format";
    format.get = [](const Mission&) -> KeyValue { return std::int64_t{kMissionFormat}; };
    format.set = [](Mission&, const KeyValue&) {};
    format.refuse = [](const KeyValue& value) {
      return std::get<std::int64_t>(value) == kMissionFormat
                 ? std::string()
                 : fmt::format("this program reads format {}", kMissionFormat);
    };
    return Table<Mission>(
        {"",
         "What the run is, before the first table.",
         "",
         false,
         {"net", "target", "environment", "integrator", "contact", "phase", "probe", "output"}},
        {format, key("title", &Mission::title, "", "what the run is called in its results"),
         key("seed", &Mission::seed, "", "start of everything random").at_least(0)});
  }();
  return table;
}

namespace {

template <class Spec>
TableView view(const Table<Spec>& table) {
  TableView out{&table.info, {}};
  for (const auto& k : table.keys) out.keys.push_back(&k);
  return out;
}

}  // namespace

const std::vector<TableView>& schema_tables() {
  static const std::vector<TableView> tables = {
      view(mission_table()),     view(net_table()),         view(thread_table()),
      view(border_table()),      view(corner_mass_table()), view(target_table()),
      view(environment_table()), view(integrator_table()),  view(contact_table()),
      view(phase_table()),       view(move_table()),        view(probe_table()),
      view(output_table())};
  return tables;
}

const TableView* find_table(const std::string& path) {
  std::string sought = path;
  for (const char* shared : {"environment", "integrator", "contact"}) {
    if (path == std::string("phase.") + shared) sought = shared;
  }
  for (const TableView& table : schema_tables()) {
    if (table.info->path == sought) return &table;
  }
  return nullptr;
}

}  // namespace retiarius

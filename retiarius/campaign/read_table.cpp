// From the collected database to CampaignTable and to CSV.
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include "retiarius/campaign/collect.hpp"
#include "retiarius/campaign/sqlite.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius {

namespace fs = std::filesystem;

namespace {

struct Columns {
  std::vector<std::string> all;
  std::vector<int> inputs, measures;
  int outcome = 0, reason = 0, success = 0, command = 0, kept = 0;
};

Columns read_columns(Database& database) {
  Columns columns;
  const std::set<std::string> fixed = {"id",   "outcome",  "reason",  "success", "missing",
                                       "seed", "versions", "command", "kept"};
  Statement rows = database.prepare("PRAGMA table_info(runs)");
  bool before_outcome = true;
  for (int at = 0; rows.step(); ++at) {
    const std::string name = rows.text(1);
    columns.all.push_back(name);
    if (name == "outcome") {
      columns.outcome = at;
      before_outcome = false;
    }
    if (name == "reason") columns.reason = at;
    if (name == "success") columns.success = at;
    if (name == "command") columns.command = at;
    if (name == "kept") columns.kept = at;
    if (fixed.count(name) > 0) continue;
    (before_outcome ? columns.inputs : columns.measures).push_back(at);
  }
  return columns;
}

Database& check_collected(Database& database) {
  if (database.has_table("runs") && database.has_table("campaign")) return database;
  throw InputError(fmt::format("{}: is no collected campaign; see `retiarius campaign collect`",
                               database.path().string()));
}

std::string value_of(Database& database, const char* key) {
  Statement find = database.prepare("SELECT value FROM campaign WHERE key = ?");
  find.bind(1, std::string(key));
  return find.step() ? find.text(0) : "";
}

CampaignDesign design_of(const std::string& name) {
  if (name == "saltelli") return CampaignDesign::saltelli;
  return name == "grid" || name == "list" ? CampaignDesign::prescribed
                                          : CampaignDesign::independent;
}

CampaignRow read_row(const Statement& rows, const Columns& columns, const fs::path& folder) {
  const auto number = [&](int at) {
    return rows.number(at).value_or(std::numeric_limits<double>::quiet_NaN());
  };
  CampaignRow row;
  row.id = rows.integer(0);
  for (const int at : columns.inputs) row.inputs.push_back(number(at));
  for (const int at : columns.measures) row.measures.push_back(number(at));
  row.outcome = rows.text(columns.outcome);
  row.reason = rows.text(columns.reason);
  if (!rows.is_null(columns.success)) row.success = rows.integer(columns.success) != 0;
  row.command = rows.text(columns.command);
  const std::string kept = rows.text(columns.kept);
  if (!kept.empty() && fs::exists(folder / kept / "report.html"))
    row.replay = kept + "/report.html";
  return row;
}

// A field as RFC 4180 has it.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string cell(const Statement& rows, int at) {
  switch (rows.kind(at)) {
    case SQLITE_NULL:
      return "";
    case SQLITE_INTEGER:
      return fmt::format("{}", rows.integer(at));
    case SQLITE_FLOAT:
      return fmt::format("{}", rows.real(at));
    default:
      return csv_field(rows.text(at));
  }
}

}  // namespace

CampaignTable read_table(const fs::path& path) {
  if (!fs::exists(path))
    throw InputError(fmt::format("{}: there is no such file; `retiarius campaign collect` makes it",
                                 path.string()));
  Database database(path);
  check_collected(database);
  const Columns columns = read_columns(database);
  CampaignTable table;
  table.title = value_of(database, "title");
  table.design = design_of(value_of(database, "design"));
  table.planned = std::stoll(value_of(database, "planned"));
  for (const int at : columns.inputs)
    table.inputs.push_back(columns.all[static_cast<std::size_t>(at)].substr(3));
  for (const int at : columns.measures)
    table.measures.push_back(columns.all[static_cast<std::size_t>(at)]);
  Statement rows = database.prepare("SELECT * FROM runs ORDER BY id");
  while (rows.step()) table.runs.push_back(read_row(rows, columns, path.parent_path()));
  table.facts = {
      fmt::format("mission {}", value_of(database, "mission")),
      fmt::format("design {}, seed {}", value_of(database, "design"), value_of(database, "seed")),
      value_of(database, "program")};
  return table;
}

void export_rows(const fs::path& path, const fs::path& csv) {
  Database database(path);
  check_collected(database);
  const Columns columns = read_columns(database);
  std::vector<std::string> fields;
  for (const std::string& name : columns.all) fields.push_back(csv_field(name));
  std::string text = fmt::format("{}\r\n", fmt::join(fields, ","));
  OutputFile file(csv);
  Statement rows = database.prepare("SELECT * FROM runs ORDER BY id");
  constexpr std::size_t kPiece = 1u << 20;
  while (rows.step()) {
    for (std::size_t at = 0; at < fields.size(); ++at)
      fields[at] = cell(rows, static_cast<int>(at));
    text += fmt::format("{}\r\n", fmt::join(fields, ","));
    if (text.size() < kPiece) continue;
    file.write(text);
    text.clear();
  }
  file.write(text);
  file.sync();
  file.close();
}

std::string collected_row(const fs::path& path, std::int64_t id) {
  Database database(path);
  check_collected(database);
  const Columns columns = read_columns(database);
  Statement rows = database.prepare("SELECT * FROM runs WHERE id = ?");
  rows.bind(1, id);
  if (!rows.step()) return {};
  std::string text;
  for (std::size_t at = 0; at < columns.all.size(); ++at)
    text += columns.all[at] + "=" + cell(rows, static_cast<int>(at)) + "\n";
  return text;
}

}  // namespace retiarius

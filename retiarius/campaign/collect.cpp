#include "retiarius/campaign/collect.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "retiarius/campaign/shard.hpp"
#include "retiarius/campaign/stop_rule.hpp"

namespace retiarius {

namespace fs = std::filesystem;

namespace {

// What two records of the same run must agree in.
constexpr const char* kContent =
    "seed, inputs, outcome, reason, success, measures, missing, versions, command, kept";

void merge_shard(Database& merged, const fs::path& path, Collected& collected) {
  // Attached, so that rows pass from one file to the other inside SQLite.
  Statement attach = merged.prepare("ATTACH ? AS shard");
  attach.bind(1, path.string());
  attach.run();
  {
    Statement conflict = merged.prepare(fmt::format(
        "SELECT a.id, a.host, b.host FROM merged.runs a JOIN shard.runs b ON a.id = b.id WHERE "
        "(a.seed, a.inputs, a.outcome, a.reason, a.measures, a.missing, a.versions, a.command, "
        "a.kept) IS NOT (b.seed, b.inputs, b.outcome, b.reason, b.measures, b.missing, b.versions, "
        "b.command, b.kept) OR a.success IS NOT b.success LIMIT 1"));
    if (conflict.step())
      throw InputError(fmt::format(
          "{}: run {} is recorded twice with different content, by {} and {}; remove the shard "
          "that is wrong, see `replay`",
          path.string(), conflict.integer(0), conflict.text(1), conflict.text(2)));
    Statement twice =
        merged.prepare("SELECT count(*) FROM merged.runs a JOIN shard.runs b ON a.id = b.id");
    if (twice.step()) collected.twice += twice.integer(0);
    merged.execute("INSERT OR IGNORE INTO merged.runs SELECT * FROM shard.runs");
  }
  merged.execute("DETACH shard");
}

// The names of measures in the order in which the runs bring them.
std::vector<std::string> measure_names(Database& merged) {
  std::vector<std::string> names;
  Statement rows = merged.prepare("SELECT measures FROM merged.runs ORDER BY id");
  while (rows.step()) {
    for (const Measure& measure : measures_of(rows.text(0)))
      if (std::find(names.begin(), names.end(), measure.name) == names.end())
        names.push_back(measure.name);
  }
  return names;
}

void bind_measure(Statement& insert, int at, const Measures& measures, const std::string& name) {
  for (const Measure& measure : measures) {
    if (measure.name != name) continue;
    if (const double* number = std::get_if<double>(&measure.value)) {
      insert.bind(at, *number);
      return;
    }
    if (const std::int64_t* count = std::get_if<std::int64_t>(&measure.value)) {
      insert.bind(at, *count);
      return;
    }
    if (const bool* truth = std::get_if<bool>(&measure.value)) {
      insert.bind(at, static_cast<std::int64_t>(*truth));
      return;
    }
  }
  insert.bind_null(at);
}

std::string columns_of_runs(const std::vector<std::string>& inputs,
                            const std::vector<std::string>& measures) {
  std::string sql = "id INTEGER PRIMARY KEY";
  for (const std::string& name : inputs) sql += ", " + sql_name("in_" + name) + " REAL";
  sql += ", outcome TEXT NOT NULL, reason TEXT, success INTEGER";
  // Without a type, counts and truth values stay integers.
  for (const std::string& name : measures) sql += ", " + sql_name(name);
  return sql + ", missing TEXT, seed INTEGER, versions TEXT, command TEXT, kept TEXT";
}

void write_runs(Database& out, const std::vector<std::string>& inputs,
                const std::vector<std::string>& measures) {
  out.execute("CREATE TABLE main.runs (" + columns_of_runs(inputs, measures) + ")");
  const std::size_t columns = 4 + inputs.size() + measures.size() + 5;
  std::string marks = "?";
  for (std::size_t i = 1; i < columns; ++i) marks += ", ?";
  Statement insert = out.prepare("INSERT INTO main.runs VALUES (" + marks + ")");
  Statement rows = out.prepare(fmt::format("SELECT id, {} FROM merged.runs ORDER BY id", kContent));
  const auto text_or_null = [&](int at, const std::string& text) {
    if (text.empty()) {
      insert.bind_null(at);
    } else {
      insert.bind(at, text);
    }
  };
  while (rows.step()) {
    int at = 0;  // of the column before
    insert.bind(++at, rows.integer(0));
    const std::vector<double> values = inputs_of(rows.text(2));
    for (std::size_t i = 0; i < inputs.size(); ++i) insert.bind(++at, values.at(i));
    insert.bind(++at, rows.text(3));
    text_or_null(++at, rows.text(4));
    ++at;
    if (rows.is_null(5)) {
      insert.bind_null(at);
    } else {
      insert.bind(at, rows.integer(5));
    }
    const Measures found = measures_of(rows.text(6));
    for (const std::string& name : measures) bind_measure(insert, ++at, found, name);
    text_or_null(++at, rows.text(7));
    insert.bind(++at, rows.integer(1));
    insert.bind(++at, rows.text(8));
    insert.bind(++at, rows.text(9));
    text_or_null(++at, rows.text(10));
    insert.run();
  }
}

const char* design_name(Design design) {
  switch (design) {
    case Design::grid:
      return "grid";
    case Design::list:
      return "list";
    case Design::latin_hypercube:
      return "latin-hypercube";
    case Design::sobol:
      return "sobol";
    case Design::monte_carlo:
      return "monte-carlo";
    case Design::saltelli:
      return "saltelli";
  }
  return "";
}

void write_campaign(Database& out, const Campaign& campaign, std::int64_t planned) {
  out.execute("CREATE TABLE main.campaign (key TEXT PRIMARY KEY, value TEXT)");
  Statement insert = out.prepare("INSERT INTO main.campaign VALUES (?, ?)");
  const CampaignSpec& spec = campaign.spec();
  const std::pair<const char*, std::string> rows[] = {{"title", spec.title},
                                                      {"design", design_name(spec.plan.design)},
                                                      {"seed", fmt::format("{}", spec.plan.seed)},
                                                      {"planned", fmt::format("{}", planned)},
                                                      {"mission", spec.mission_path()},
                                                      {"program", campaign.identity().program},
                                                      {"identity", campaign.identity().text()},
                                                      {"file", spec.canonical}};
  for (const auto& [key, value] : rows) {
    insert.bind(1, std::string(key)).bind(2, value);
    insert.run();
  }
}

// All shards in one table `merged.runs`, without what the stop rule leaves out.
Collected merge(Database& out, const Campaign& campaign, const fs::path& folder,
                const fs::path& scratch) {
  Collected collected;
  Statement attach = out.prepare("ATTACH ? AS merged");
  attach.bind(1, scratch.string());
  attach.run();
  out.execute("PRAGMA merged.journal_mode = OFF; PRAGMA merged.synchronous = OFF");
  out.execute(
      "CREATE TABLE merged.runs (id INTEGER PRIMARY KEY, seed, inputs, outcome, reason, success, "
      "measures, missing, versions, command, kept, host, engine, started, wall_time, attempts)");
  for (const fs::path& path : find_shards(folder)) {
    {
      Database shard(path);
      if (!check_shard(shard, campaign.identity())) continue;
    }
    merge_shard(out, path, collected);
  }
  std::vector<std::uint8_t> states(static_cast<std::size_t>(campaign.plan().runs()), kNotDone);
  Statement rows = out.prepare("SELECT id, success FROM merged.runs WHERE id >= 0 AND id < ?");
  rows.bind(1, campaign.plan().runs());
  while (rows.step()) {
    std::optional<bool> success;
    if (!rows.is_null(1)) success = rows.integer(1) != 0;
    states[static_cast<std::size_t>(rows.integer(0))] = run_state(success);
  }
  rows.reset();
  StopRule rule(campaign.spec().stop, campaign.plan().runs());
  rule.update(states);
  collected.planned = rule.end();
  Statement cut = out.prepare("DELETE FROM merged.runs WHERE id < 0 OR id >= ?");
  cut.bind(1, rule.end());
  cut.run();
  return collected;
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

}  // namespace

Collected collect(const Campaign& campaign, const fs::path& folder) {
  const fs::path written = folder / "campaign.sqlite.part", scratch = folder / "merged.part";
  remove_quietly(written);
  remove_quietly(scratch);
  Collected collected;
  try {
    Database out(written, true);
    out.execute("PRAGMA journal_mode = OFF; PRAGMA synchronous = FULL");
    collected = merge(out, campaign, folder, scratch);
    out.execute("BEGIN");
    write_runs(out, campaign.spec().input_names(), measure_names(out));
    out.execute(
        "CREATE TABLE main.timings (id INTEGER PRIMARY KEY, host TEXT, engine TEXT, started TEXT, "
        "wall_time REAL, attempts INTEGER)");
    out.execute(
        "INSERT INTO main.timings SELECT id, host, engine, started, wall_time, attempts FROM "
        "merged.runs ORDER BY id");
    write_campaign(out, campaign, collected.planned);
    out.execute("COMMIT");
    Statement count = out.prepare("SELECT count(*) FROM main.runs");
    if (count.step()) collected.runs = count.integer(0);
  } catch (...) {
    remove_quietly(written);
    remove_quietly(scratch);
    throw;
  }
  remove_quietly(scratch);
  std::error_code error;
  fs::rename(written, folder / "campaign.sqlite", error);
  if (error)
    throw RunError(fmt::format("{}: {}", (folder / "campaign.sqlite").string(), error.message()));
  return collected;
}

}  // namespace retiarius

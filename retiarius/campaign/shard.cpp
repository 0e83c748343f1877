#include "retiarius/campaign/shard.hpp"

#include <algorithm>
#include <cstdio>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace retiarius {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr int kShardFormat = 1;

constexpr const char* kTables = R"(
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT);
CREATE TABLE runs (
  id INTEGER PRIMARY KEY, seed INTEGER NOT NULL, inputs TEXT NOT NULL, outcome TEXT NOT NULL,
  reason TEXT NOT NULL, success INTEGER, measures TEXT NOT NULL, missing TEXT NOT NULL,
  versions TEXT NOT NULL, command TEXT NOT NULL, kept TEXT NOT NULL,
  host TEXT NOT NULL, engine TEXT NOT NULL, started TEXT NOT NULL, wall_time REAL NOT NULL,
  attempts INTEGER NOT NULL);
CREATE INDEX states ON runs (id, outcome, success, wall_time);
)";

void make_tables(Database& database, const CampaignIdentity& identity) {
  database.execute("BEGIN");
  database.execute(kTables);
  Statement insert = database.prepare("INSERT INTO meta VALUES (?, ?)");
  const std::pair<const char*, std::string> rows[] = {{"format", std::to_string(kShardFormat)},
                                                      {"campaign", identity.campaign},
                                                      {"mission", identity.mission},
                                                      {"program", identity.program}};
  for (const auto& [key, value] : rows) {
    insert.bind(1, std::string(key)).bind(2, value);
    insert.run();
  }
  database.execute("COMMIT");
}

std::string different(const std::map<std::string, std::string>& meta,
                      const CampaignIdentity& identity) {
  const auto is = [&](const char* key, const std::string& value) {
    const auto found = meta.find(key);
    return found != meta.end() && found->second == value;
  };
  if (!is("format", std::to_string(kShardFormat))) return "another format of results";
  if (!is("mission", identity.mission))
    return "another mission: it, or a file that it names, has changed since";
  if (!is("campaign", identity.campaign)) return "another campaign: its file has changed since";
  if (!is("program", identity.program))
    return fmt::format("another program ({}; this is {})", meta.at("program"), identity.program);
  return {};
}

// Whether the name says that no id from `first` to before `last` is in the shard.
bool holds_others(const fs::path& path, std::int64_t first, std::int64_t last) {
  long long low = 0, high = 0;
  if (std::sscanf(path.filename().c_str(), "ids-%lld-%lld-", &low, &high) != 2) return false;
  return high < first || low >= last;
}

}  // namespace

bool check_shard(Database& shard, const CampaignIdentity& identity) {
  if (!shard.has_table("meta")) return false;
  std::map<std::string, std::string> meta;
  Statement rows = shard.prepare("SELECT key, value FROM meta");
  while (rows.step()) meta[rows.text(0)] = rows.text(1);
  const std::string why = different(meta, identity);
  if (why.empty()) return true;
  throw InputError(fmt::format("{}: holds results of {}; use another folder, or undo the change",
                               shard.path().string(), why));
}

Shard::Shard(const fs::path& path, const CampaignIdentity& identity) : database_(path, true) {
  // A rollback journal, kept and emptied, costs the fewest waits for the device of all ways that
  // survive a power cut and do not need shared memory, which network file systems lack.
  database_.execute("PRAGMA journal_mode = TRUNCATE; PRAGMA synchronous = FULL");
  if (!check_shard(database_, identity)) make_tables(database_, identity);
  insert_.emplace(database_.prepare(
      "INSERT INTO runs VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"));
}

bool Shard::has(std::int64_t id) { return state(id) != kNotDone; }

RunState Shard::state(std::int64_t id) {
  Statement find = database_.prepare("SELECT success FROM runs WHERE id = ?");
  find.bind(1, id);
  if (!find.step()) return kNotDone;
  if (find.is_null(0)) return kNoAnswer;
  return run_state(find.integer(0) != 0);
}

void Shard::write(const RunRecord& r) {
  insert_->bind(1, r.id).bind(2, r.seed).bind(3, inputs_text(r.inputs));
  insert_->bind(4, r.outcome).bind(5, r.reason);
  if (r.success) {
    insert_->bind(6, static_cast<std::int64_t>(*r.success));
  } else {
    insert_->bind_null(6);
  }
  insert_->bind(7, measures_text(r.measures)).bind(8, r.missing).bind(9, r.versions);
  insert_->bind(10, r.command).bind(11, r.kept).bind(12, r.host).bind(13, r.engine);
  insert_->bind(14, r.started).bind(15, r.wall_time).bind(16, r.attempts);
  insert_->run();
}

std::vector<fs::path> find_shards(const fs::path& folder) {
  std::vector<fs::path> shards;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder / "shards", error))
    if (entry.path().extension() == ".sqlite") shards.push_back(entry.path());
  std::sort(shards.begin(), shards.end());
  return shards;
}

RunState run_state(const std::optional<bool>& success) {
  if (!success) return kNoAnswer;
  return *success ? kSuccess : kNoSuccess;
}

std::string ids_in_name(std::int64_t first, std::int64_t last) {
  return fmt::format("ids-{}-{}-", first, last - 1);
}

Progress read_progress(const fs::path& folder, const Campaign& campaign) {
  return read_progress(folder, campaign, 0, campaign.plan().runs());
}

Progress read_progress(const fs::path& folder, const Campaign& campaign, std::int64_t first,
                       std::int64_t last) {
  Progress progress;
  progress.states.assign(static_cast<std::size_t>(campaign.plan().runs()), kNotDone);
  std::map<std::string, std::int64_t> outcomes;
  for (const fs::path& path : find_shards(folder)) {
    if (holds_others(path, first, last)) continue;
    Database shard(path);
    if (!check_shard(shard, campaign.identity())) continue;
    ++progress.shards;
    Statement rows =
        shard.prepare("SELECT id, outcome, success, wall_time FROM runs INDEXED BY states");
    while (rows.step()) {
      const std::int64_t id = rows.integer(0);
      if (id < 0 || id >= campaign.plan().runs()) continue;
      std::uint8_t& state = progress.states[static_cast<std::size_t>(id)];
      if (state != kNotDone) continue;  // another process did it too
      std::optional<bool> success;
      if (!rows.is_null(2)) success = rows.integer(2) != 0;
      state = run_state(success);
      ++progress.done;
      ++outcomes[rows.text(1)];
      progress.wall_time += rows.real(3);
    }
  }
  for (const auto& [outcome, runs] : outcomes) progress.outcomes.push_back({outcome, runs});
  return progress;
}

std::vector<std::string> content_lines(const RunRecord& record) {
  std::vector<std::string> lines = {"outcome " + record.outcome, "reason " + record.reason,
                                    "inputs " + inputs_text(record.inputs),
                                    fmt::format("seed {}", record.seed)};
  const RunState state = run_state(record.success);
  lines.push_back(fmt::format("success {}", state == kNoAnswer  ? "-"
                                            : state == kSuccess ? "1"
                                                                : "0"));
  for (const Measure& measure : record.measures)
    lines.push_back(measure.name + " " + measures_text({measure}));
  lines.push_back("missing " + record.missing);
  return lines;
}

std::optional<RunRecord> find_record(const fs::path& folder, const Campaign& campaign,
                                     std::int64_t id) {
  for (const fs::path& path : find_shards(folder)) {
    Database shard(path);
    if (!check_shard(shard, campaign.identity())) continue;
    Statement row = shard.prepare(
        "SELECT seed, inputs, outcome, reason, success, measures, missing FROM runs WHERE id = ?");
    row.bind(1, id);
    if (!row.step()) continue;
    RunRecord record;
    record.id = id;
    record.seed = row.integer(0);
    record.inputs = inputs_of(row.text(1));
    record.outcome = row.text(2);
    record.reason = row.text(3);
    if (!row.is_null(4)) record.success = row.integer(4) != 0;
    record.measures = measures_of(row.text(5));
    record.missing = row.text(6);
    return record;
  }
  return std::nullopt;
}

std::string inputs_text(const std::vector<double>& inputs) { return Json(inputs).dump(); }

std::vector<double> inputs_of(const std::string& text) {
  return Json::parse(text).get<std::vector<double>>();
}

std::string measures_text(const Measures& measures) {
  Json object = Json::object();
  for (const Measure& measure : measures) {
    Json& value = object[measure.name];
    if (const double* number = std::get_if<double>(&measure.value)) value = *number;
    if (const std::int64_t* count = std::get_if<std::int64_t>(&measure.value)) value = *count;
    if (const bool* truth = std::get_if<bool>(&measure.value)) value = *truth;
  }
  return object.dump();
}

Measures measures_of(const std::string& text) {
  Measures measures;
  const Json object = Json::parse(text);
  for (const auto& [name, value] : object.items()) {
    Measure measure{name, "", std::monostate{}};
    if (value.is_boolean()) {
      measure.value = value.get<bool>();
    } else if (value.is_number_float()) {
      measure.value = value.get<double>();
    } else if (value.is_number_integer()) {
      measure.value = value.get<std::int64_t>();
    }
    measures.push_back(std::move(measure));
  }
  return measures;
}

}  // namespace retiarius

// The database files that processes at work write, one each, in DIR/shards.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/campaign/campaign.hpp"
#include "retiarius/campaign/run_record.hpp"
#include "retiarius/campaign/sqlite.hpp"

namespace retiarius {

// How far each run is, a byte each.
enum RunState : std::uint8_t { kNotDone = 0, kNoAnswer = 1, kNoSuccess = 2, kSuccess = 3 };
RunState run_state(const std::optional<bool>& success);

// Table `runs`, a row for each run that is done; inputs and measures are JSON. Each row is a
// transaction of its own, on the device before write() returns, so that a power cut costs the runs
// that were under way. One process writes a shard; others may read it meanwhile.
class Shard {
 public:
  // Opens the file or makes it. Throws InputError where it holds results of another identity, and
  // RunError where it cannot be written.
  Shard(const std::filesystem::path& path, const CampaignIdentity& identity);

  bool has(std::int64_t id);
  RunState state(std::int64_t id);  // kNotDone where it is not there
  void write(const RunRecord& record);

 private:
  Database database_;
  std::optional<Statement> insert_;
};

// The shards of a campaign's folder in order of their names; none where there is no folder.
std::vector<std::filesystem::path> find_shards(const std::filesystem::path& folder);

// Throws InputError where the shard holds results of another identity, naming what differs. False
// for a file without any content, which a process left that was ended while it made it.
bool check_shard(Database& shard, const CampaignIdentity& identity);

struct OutcomeCount {
  std::string outcome;
  std::int64_t runs = 0;
};

struct Progress {
  std::vector<std::uint8_t> states;    // of RunState, one for each run of the plan
  std::vector<OutcomeCount> outcomes;  // by name
  std::int64_t done = 0;
  std::size_t shards = 0;
  double wall_time = 0.0;  // s, of all runs together
};

// Reads all shards of the folder. Throws InputError as check_shard() does.
Progress read_progress(const std::filesystem::path& folder, const Campaign& campaign);

// The same without shards whose names say that they hold other ids than those from `first` to
// before `last`: of ten thousand tasks, none need read what all others have written.
Progress read_progress(const std::filesystem::path& folder, const Campaign& campaign,
                       std::int64_t first, std::int64_t last);

// What a shard's name begins with that holds these ids alone.
std::string ids_in_name(std::int64_t first, std::int64_t last);

// What a record says of the run itself, a line each; as far as repeating it must give the same.
std::vector<std::string> content_lines(const RunRecord& record);

// The record of a run in the folder's shards; host and timings are left out. None: it is not done.
std::optional<RunRecord> find_record(const std::filesystem::path& folder, const Campaign& campaign,
                                     std::int64_t id);

// JSON of inputs and measures; numbers read back to the same bits.
std::string inputs_text(const std::vector<double>& inputs);
std::vector<double> inputs_of(const std::string& text);
std::string measures_text(const Measures& measures);
Measures measures_of(const std::string& text);

}  // namespace retiarius

// The file `checkpoint`: the complete State of a run and what else steers the rest of it, from
// which it can be resumed.
//
// Layout, little endian: 8 bytes "RETCKPT\n", u32 format number, u32 zero, u64 size of the payload,
// payload, u64 FNV-1a checksum of everything before it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "retiarius/mission/observer.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

inline constexpr std::uint32_t kCheckpointFormat = 3;

// 64-bit FNV-1a of the bytes (Fowler, Noll and Vo; the constants of RFC 9923).
std::uint64_t fnv1a(std::string_view bytes);

// Of a run: what must be the same where it goes on.
struct RunIdentity {
  std::string version, revision;  // of the program
  std::string kernels;
  std::uint64_t mission = 0;  // fnv1a of resolved.toml
  std::uint64_t model = 0;    // of the net and the bodies that were built; see model_hash()
};

// What tells one net with its bodies from another: files that a mission names may change.
std::uint64_t model_hash(const Network& network, const std::vector<Body>& bodies);

// The content of a checkpoint file.
struct SavedRun {
  RunIdentity identity;
  Checkpoint checkpoint;
};

// The bytes of a checkpoint file.
std::string encode_checkpoint(const SavedRun& saved);

// What is in the bytes of a checkpoint file; bit for bit what was encoded. `name` is for
// messages. Throws InputError when the bytes are not a whole checkpoint of this format.
SavedRun decode_checkpoint(std::string_view bytes, const std::string& name);

// The same of a checkpoint file.
SavedRun read_saved_run(const std::filesystem::path& file);

// The state in a checkpoint file, or in the newest whole one of a run folder: `checkpoint`, or
// `checkpoint.previous` when the newest is torn or missing. A file named directly falls back on
// its own ".previous" in the same way. Throws InputError when neither can be used.
State read_checkpoint(const std::filesystem::path& path);

// The file that stands in where `checkpoint` cannot be used.
std::filesystem::path previous_checkpoint(const std::filesystem::path& path);

// Replaces `checkpoint` atomically and keeps one before as `checkpoint.previous`. Of these two one
// is always durable: to wait for the device at every frame would take longer than computing it.
class CheckpointFile : public Observer {
 public:
  explicit CheckpointFile(const std::filesystem::path& folder, RunIdentity identity = {})
      : path_(folder / "checkpoint"), identity_(std::move(identity)) {}
  void begin(const RunModel& model) override;
  void save(const Checkpoint& saved, bool durable) override;

 private:
  std::filesystem::path path_;
  RunIdentity identity_;
  bool newest_is_durable_ = false;
};

}  // namespace retiarius

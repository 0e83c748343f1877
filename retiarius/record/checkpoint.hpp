// The file `checkpoint`: the complete State of a run, from which it can be resumed.
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

inline constexpr std::uint32_t kCheckpointFormat = 2;

// 64-bit FNV-1a of the bytes (Fowler, Noll and Vo; the constants of RFC 9923).
std::uint64_t fnv1a(std::string_view bytes);

// The bytes of a checkpoint file.
std::string encode_checkpoint(const State& state);

// The state in the bytes of a checkpoint file; bit for bit what was encoded. `name` is for
// messages. Throws InputError when the bytes are not a whole checkpoint of this format.
State decode_checkpoint(std::string_view bytes, const std::string& name);

// Reads a checkpoint file, or the newest whole one of a run folder: `checkpoint`, or
// `checkpoint.previous` when the newest is torn or missing. A file named directly falls back on
// its own ".previous" in the same way. Throws InputError when neither can be used.
State read_checkpoint(const std::filesystem::path& path);

// Replaces `checkpoint` atomically and keeps the one before as `checkpoint.previous`.
class CheckpointFile : public Observer {
 public:
  explicit CheckpointFile(const std::filesystem::path& folder) : path_(folder / "checkpoint") {}
  void checkpoint(const State& state) override;

 private:
  std::filesystem::path path_;
};

}  // namespace retiarius

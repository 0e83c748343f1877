// Any bytes as a checkpoint: as the whole file, and as the payload of one whose frame and checksum
// are right, for no fuzzer guesses a checksum.
#include "retiarius/record/checkpoint.hpp"

#include "fuzz/target.hpp"
#include "retiarius/record/replay_chunk.hpp"

namespace {

std::string framed(std::string_view payload) {
  using namespace retiarius;
  std::string bytes = "RETCKPT\n";
  append_bytes(bytes, kCheckpointFormat);
  append_bytes(bytes, std::uint32_t{0});
  append_bytes(bytes, static_cast<std::uint64_t>(payload.size()));
  bytes += payload;
  append_bytes(bytes, fnv1a(bytes));
  return bytes;
}

void decode(std::string_view bytes) {
  using namespace retiarius;
  fuzz::accept_or_refuse([&] {
    const std::string again = encode_checkpoint(decode_checkpoint(bytes, "checkpoint"));
    fuzz::require(encode_checkpoint(decode_checkpoint(again, "again")) == again,
                  "a checkpoint changes when it is read");
  });
}

}  // namespace

RETIARIUS_FUZZ_TARGET(bytes) {
  decode(bytes);
  decode(framed(bytes));
}

// Any bytes as a recording: as the whole file, and as the contents of a header and of frames that
// follow it, in chunks whose checksums are right. In the latter the input is text up to the first
// zero byte (the header's JSON), then one byte that says how many of the rest are the header's
// arrays, and every further stretch that begins with a byte of its length is a frame.
#include "fuzz/target.hpp"
#include "retiarius/record/replay_chunk.hpp"
#include "retiarius/record/replay_codec.hpp"
#include "retiarius/record/replay_header.hpp"

namespace {

using namespace retiarius;

std::string_view taken(std::string_view& bytes) {
  if (bytes.empty()) return {};
  const std::size_t length = static_cast<unsigned char>(bytes.front());
  bytes.remove_prefix(1);
  const std::string_view part = bytes.substr(0, length);
  bytes.remove_prefix(part.size());
  return part;
}

void decode_frames(const ReplayHeader& header, std::string_view rest) {
  ReplayCodec codec(header.shape, header.scales);
  // A frame is a fixed part as it stands and a zlib stream; here the stream is given inflated.
  while (!rest.empty()) {
    const std::string_view frame = taken(rest);
    const std::size_t fixed = std::min<std::size_t>(frame.size(), 20 + 28 * header.shape.bodies);
    codec.decode(std::string(frame.substr(0, fixed)) + deflated(frame.substr(fixed)));
  }
}

}  // namespace

RETIARIUS_FUZZ_TARGET(bytes) {
  fuzz::accept_or_refuse([&] {
    const ReplayChunks chunks = read_chunks(bytes);
    fuzz::require(chunks.size <= bytes.size(), "chunks beyond the end");
  });
  fuzz::accept_or_refuse([&] {
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    std::string_view rest = bytes.substr(std::min(bytes.size(), end + 1));
    std::string content;
    append_bytes(content, static_cast<std::uint32_t>(end));
    content += bytes.substr(0, end);
    content += deflated(taken(rest));
    decode_frames(read_replay_header(content), rest);
  });
}

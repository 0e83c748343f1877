// The chunks of a recording: pieces that are appended whole and checked one by one.
//
// replay.bin starts with kReplayMagic (8 bytes) and a 32-bit format number, 1, then 32 bits of
// zero. Chunks follow, each: 4 letters that name it, the 32-bit size of its content, the content,
// and the 32-bit CRC (that of zlib and PNG) of everything before it in the chunk. Integers and
// floating-point numbers are little endian. A reader of a growing file stops at the first chunk
// that is not there completely and comes back later; a wrong checksum means a damaged file.
//
// HEAD  32-bit size of a JSON text, the text, and a zlib stream of the arrays that the text lists
// FRAM  one instant; see replay_codec.hpp
// ENDS  JSON: how the run ended; the last chunk. A run that was killed has none.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace retiarius {

inline constexpr std::string_view kReplayMagic = "RETREPL\n";
inline constexpr std::uint32_t kReplayFormat = 1;

// What the file begins with, before the first chunk.
std::string replay_preamble();

// `name` has four letters. Throws Error for content of 4 GB or more.
std::string replay_chunk(std::string_view name, std::string_view content);

struct ReplayChunk {
  std::string_view name;
  std::string_view content;
};

struct ReplayChunks {
  std::vector<ReplayChunk> chunks;  // refer to the bytes that were given
  std::size_t size = 0;             // bytes up to the end of the last whole chunk
};

// The whole chunks of a file that may be growing or cut. Throws InputError where the bytes are no
// recording, have another format, or fail a checksum.
ReplayChunks read_chunks(std::string_view bytes);

// zlib streams. Parts of one stream are coded apart, which pays where their bytes are distributed
// differently. inflated() throws InputError for bytes that are none.
std::string deflated(std::string_view bytes);
std::string deflated(const std::vector<std::string_view>& parts);
std::string inflated(std::string_view bytes);

// Appends the bytes of a number or of many, as they lie in memory.
template <class T>
void append_bytes(std::string& bytes, const T& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}
template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& numbers) {
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
}

}  // namespace retiarius

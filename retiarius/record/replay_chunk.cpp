#include "retiarius/record/replay_chunk.hpp"

#include <bit>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <zlib.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

constexpr std::size_t kBefore = 8, kAfter = 4;  // bytes of a chunk around its content

std::uint32_t checksum(std::string_view bytes) {
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  return static_cast<std::uint32_t>(::crc32_z(0, data, bytes.size()));
}

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof number);
  return number;
}

void check_preamble(std::string_view bytes) {
  if (bytes.substr(0, kReplayMagic.size()) != kReplayMagic)
    throw InputError("it is no recording: it does not start with the letters RETREPL");
  const std::uint32_t format = number_at(bytes, kReplayMagic.size());
  if (format != kReplayFormat)
    throw InputError(fmt::format("the recording has format {}, this version reads format {}",
                                 format, kReplayFormat));
}

}  // namespace

std::string replay_preamble() {
  std::string bytes(kReplayMagic);
  append_bytes(bytes, kReplayFormat);
  append_bytes(bytes, std::uint32_t{0});
  return bytes;
}

std::string replay_chunk(std::string_view name, std::string_view content) {
  if (content.size() > std::numeric_limits<std::uint32_t>::max())
    throw Error(fmt::format("a chunk of {} bytes is too large for a recording", content.size()));
  std::string bytes;
  bytes.reserve(content.size() + kBefore + kAfter);
  bytes += name.substr(0, 4);
  append_bytes(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += content;
  append_bytes(bytes, checksum(bytes));
  return bytes;
}

ReplayChunks read_chunks(std::string_view bytes) {
  ReplayChunks result;
  const std::size_t preamble = replay_preamble().size();
  if (bytes.size() < preamble) {
    if (!kReplayMagic.starts_with(bytes.substr(0, kReplayMagic.size()))) check_preamble(bytes);
    return result;
  }
  check_preamble(bytes);
  result.size = preamble;
  while (bytes.size() - result.size >= kBefore + kAfter) {
    const std::size_t start = result.size;
    const std::size_t content = number_at(bytes, start + 4);
    if (bytes.size() - start < kBefore + content + kAfter) break;
    const std::string_view checked = bytes.substr(start, kBefore + content);
    if (checksum(checked) != number_at(bytes, start + kBefore + content))
      throw InputError(fmt::format("the recording is damaged: wrong checksum at byte {}", start));
    result.chunks.push_back({checked.substr(0, 4), checked.substr(kBefore)});
    result.size = start + kBefore + content + kAfter;
  }
  return result;
}

std::string deflated(std::string_view bytes) {
  return deflated(std::vector<std::string_view>{bytes});
}

std::string deflated(const std::vector<std::string_view>& parts) {
  z_stream stream{};
  // "Filtered" looks for matches less eagerly, which suits small numbers without pattern.
  if (::deflateInit2(&stream, 6, Z_DEFLATED, MAX_WBITS, 9, Z_FILTERED) != Z_OK)
    throw Error("no memory to compress a recording");
  std::size_t total = 0;
  for (std::string_view part : parts) total += part.size();
  // Each end of a block may take a few bytes more than the bound knows of.
  std::string result(::deflateBound(&stream, total) + 16 * parts.size(), '\0');
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  int state = Z_OK;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(parts[k].data()));
    stream.avail_in = static_cast<uInt>(parts[k].size());
    state = ::deflate(&stream, k + 1 < parts.size() ? Z_BLOCK : Z_FINISH);
  }
  result.resize(stream.total_out);
  ::deflateEnd(&stream);
  if (state != Z_STREAM_END) throw Error("a recording could not be compressed");
  return result;
}

std::string inflated(std::string_view bytes) {
  z_stream stream{};
  if (::inflateInit(&stream) != Z_OK) throw Error("no memory to read a recording");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string result;
  int state = Z_OK;
  while (state == Z_OK) {
    const std::size_t done = result.size();
    result.resize(done + std::max<std::size_t>(bytes.size(), 4096) * 2);
    stream.next_out = reinterpret_cast<Bytef*>(result.data() + done);
    stream.avail_out = static_cast<uInt>(result.size() - done);
    state = ::inflate(&stream, Z_NO_FLUSH);
    result.resize(result.size() - stream.avail_out);
  }
  ::inflateEnd(&stream);
  if (state != Z_STREAM_END) throw InputError("the recording is damaged: it does not inflate");
  return result;
}

}  // namespace retiarius

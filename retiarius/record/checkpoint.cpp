#include "retiarius/record/checkpoint.hpp"

#include <bit>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"

namespace retiarius {

namespace {

constexpr std::string_view kMagic = "RETCKPT\n";
constexpr std::size_t kHeaderSize = 24;
constexpr std::size_t kChecksumSize = 8;

// Both directions share one list of members (`transfer` below), so they cannot disagree.
class Writer {
 public:
  static constexpr bool kReads = false;

  void number(std::uint64_t bits, int bytes) {
    for (int k = 0; k < bytes; ++k) bytes_ += static_cast<char>(bits >> (8 * k) & 0xff);
  }
  void value(const double& v) { number(std::bit_cast<std::uint64_t>(v), 8); }
  void value(const std::int64_t& v) { number(static_cast<std::uint64_t>(v), 8); }
  void value(const Index& v) { number(static_cast<std::uint32_t>(v), 4); }
  void value(const bool& v) { number(v ? 1 : 0, 1); }
  std::size_t size(std::size_t actual) {
    number(actual, 8);
    return actual;
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  static constexpr bool kReads = true;

  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number(std::size_t bytes) {
    if (bytes > bytes_.size()) throw Error("it ends too early");
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < bytes; ++k)
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes_[k])) << (8 * k);
    bytes_.remove_prefix(bytes);
    return bits;
  }
  void value(double& v) { v = std::bit_cast<double>(number(8)); }
  void value(std::int64_t& v) { v = static_cast<std::int64_t>(number(8)); }
  void value(Index& v) { v = static_cast<Index>(static_cast<std::uint32_t>(number(4))); }
  void value(bool& v) { v = number(1) != 0; }
  std::size_t size(std::size_t) {
    const std::uint64_t count = number(8);
    // Each element has at least one byte: a count beyond that is nonsense, not a big net.
    if (count > bytes_.size()) throw Error("it ends too early");
    return static_cast<std::size_t>(count);
  }
  bool finished() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

// The structured bindings name every member: one that is added to State does not compile until
// it is listed here (and the format number raised).
template <class Archive>
void transfer(Archive& a, Vec3& v) {
  for (double& c : v) a.value(c);
}

template <class Archive>
void transfer(Archive& a, BodyState& s) {
  auto& [position, attitude, velocity, angular_momentum] = s;
  transfer(a, position);
  for (double& c : attitude.coeffs()) a.value(c);
  transfer(a, velocity);
  transfer(a, angular_momentum);
}

template <class Archive>
void transfer(Archive& a, Touch& t) {
  auto& [node, body, sticks, reaction] = t;
  a.value(node);
  a.value(body);
  a.value(sticks);
  transfer(a, reaction);
}

template <class Archive>
void transfer(Archive& a, Account& s) {
  auto& [material, environment, friction, impact, work, impulse, angular_impulse] = s;
  for (double* v : {&material, &environment, &friction, &impact, &work}) a.value(*v);
  transfer(a, impulse);
  transfer(a, angular_impulse);
}

template <class Archive, class Element>
void transfer(Archive& a, std::vector<Element>& list) {
  const std::size_t count = a.size(list.size());
  if constexpr (Archive::kReads) list.resize(count);
  for (Element& element : list) transfer(a, element);
}

template <class Archive>
void transfer(Archive& a, Memory& m) {
  auto& [acceleration, outside_force, outside_moment, next_step] = m;
  transfer(a, acceleration);
  transfer(a, outside_force);
  transfer(a, outside_moment);
  a.value(next_step);
}

template <class Archive>
void transfer(Archive& a, State& s) {
  auto& [time, step, x, v, bodies, touches, support, account, memory] = s;
  a.value(time);
  a.value(step);
  transfer(a, x);
  transfer(a, v);
  transfer(a, bodies);
  transfer(a, touches);
  transfer(a, support);
  transfer(a, account);
  transfer(a, memory);
}

std::string payload_of(State state) {
  Writer writer;
  transfer(writer, state);
  return writer.take();
}

// What is wrong with the frame around the payload; throws Error without the file's name.
std::string_view checked_payload(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, kMagic.size());
  if (start != kMagic.substr(0, start.size())) throw Error("it is not a checkpoint");
  if (bytes.size() < kHeaderSize + kChecksumSize) throw Error("it ends too early");
  Reader header(bytes.substr(kMagic.size()));
  const auto format = header.number(4);
  if (format != kCheckpointFormat)
    throw Error(
        fmt::format("it has format {}, this version reads format {}", format, kCheckpointFormat));
  header.number(4);
  if (header.number(8) != bytes.size() - kHeaderSize - kChecksumSize)
    throw Error("its length is not the one it states");
  const std::size_t end = bytes.size() - kChecksumSize;
  if (Reader(bytes.substr(end)).number(8) != fnv1a(bytes.substr(0, end)))
    throw Error("its checksum does not match");
  return bytes.substr(kHeaderSize, end - kHeaderSize);
}

}  // namespace

std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (char c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3u;
  }
  return hash;
}

std::string encode_checkpoint(const State& state) {
  const std::string payload = payload_of(state);
  Writer header;
  header.number(kCheckpointFormat, 4);
  header.number(0, 4);
  header.number(payload.size(), 8);
  std::string bytes = std::string(kMagic) + header.take() + payload;
  Writer checksum;
  checksum.number(fnv1a(bytes), 8);
  return bytes + checksum.take();
}

State decode_checkpoint(std::string_view bytes, const std::string& name) {
  try {
    Reader reader(checked_payload(bytes));
    State state;
    transfer(reader, state);
    if (!reader.finished()) throw Error("it is longer than its content");
    return state;
  } catch (const InputError&) {
    throw;
  } catch (const Error& error) {
    throw InputError(fmt::format("cannot use the checkpoint {}: {}", name, error.what()));
  }
}

State read_checkpoint(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(path, ignored);
  const std::filesystem::path newest = folder ? path / "checkpoint" : path;
  std::filesystem::path previous = newest;
  previous += ".previous";
  std::string complaint;
  try {
    return decode_checkpoint(read_whole_file(newest), newest.string());
  } catch (const InputError& error) {
    if (!std::filesystem::exists(previous, ignored)) throw;
    complaint = error.what();
  }
  try {
    return decode_checkpoint(read_whole_file(previous), previous.string());
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}; {}", complaint, error.what()));
  }
}

void CheckpointFile::checkpoint(const State& state) {
  std::filesystem::path previous = path_;
  previous += ".previous";
  replace_keeping(path_, previous, encode_checkpoint(state));
}

}  // namespace retiarius

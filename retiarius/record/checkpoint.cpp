#include "retiarius/record/checkpoint.hpp"

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/file.hpp"
#include "retiarius/state/transfer.hpp"

namespace retiarius {

namespace {

constexpr std::string_view kMagic = "RETCKPT\n";
constexpr std::size_t kHeaderSize = 24;
constexpr std::size_t kChecksumSize = 8;

void transfer(Archive& archive, SavedRun& saved) {
  auto& [version, revision, kernels, mission, model] = saved.identity;
  archive(version, revision, kernels, mission, model);
  auto& [state, rows, frames, ended, fresh, progress] = saved.checkpoint;
  archive(state, rows, frames, ended, fresh, progress);
}

std::string as_bytes(std::uint64_t number, std::size_t count) {
  return {reinterpret_cast<const char*>(&number), count};
}

std::uint64_t number_in(std::string_view bytes, std::size_t count) {
  std::uint64_t number = 0;
  Archive(bytes).raw(&number, count);
  return number;
}

// What is wrong with the frame around the payload; throws Error without the file's name.
std::string_view checked_payload(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, kMagic.size());
  if (start != kMagic.substr(0, start.size())) throw Error("it is not a checkpoint");
  if (bytes.size() < kHeaderSize + kChecksumSize) throw Error("it ends too early");
  const auto format = number_in(bytes.substr(8), 4);
  if (format != kCheckpointFormat)
    throw Error(
        fmt::format("it has format {}, this version reads format {}", format, kCheckpointFormat));
  if (number_in(bytes.substr(16), 8) != bytes.size() - kHeaderSize - kChecksumSize)
    throw Error("its length is not the one it states");
  const std::size_t end = bytes.size() - kChecksumSize;
  if (number_in(bytes.substr(end), 8) != fnv1a(bytes.substr(0, end)))
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

std::uint64_t model_hash(const Network& network, const std::vector<Body>& bodies) {
  Archive archive;
  const auto add = [&archive](auto value) { archive(value); };
  add(network.design);
  add(network.initial);
  add(network.mass);
  for (const Segment& s : network.segments) {
    add(s.a);
    add(s.b);
    add(s.rest_length);
    add(s.material);
  }
  for (const Body& body : bodies) {
    const TriangleMesh mesh = body.shape->triangles();
    add(mesh.vertices);
    for (const auto& triangle : mesh.triangles)
      for (const Index k : triangle) add(k);
    add(body.mass);
    add(body.shape->bounding_radius());
  }
  return fnv1a(archive.take());
}

std::string encode_checkpoint(const SavedRun& saved) {
  Archive archive;
  SavedRun copy = saved;
  transfer(archive, copy);
  const std::string payload = archive.take();
  const std::string bytes = std::string(kMagic) + as_bytes(kCheckpointFormat, 4) + as_bytes(0, 4) +
                            as_bytes(payload.size(), 8) + payload;
  return bytes + as_bytes(fnv1a(bytes), 8);
}

SavedRun decode_checkpoint(std::string_view bytes, const std::string& name) {
  try {
    Archive archive(checked_payload(bytes));
    SavedRun saved;
    transfer(archive, saved);
    if (!archive.finished()) throw Error("it is longer than its content");
    return saved;
  } catch (const Error& error) {
    throw InputError(fmt::format("cannot use the checkpoint {}: {}", name, error.what()));
  }
}

SavedRun read_saved_run(const std::filesystem::path& file) {
  return decode_checkpoint(read_whole_file(file), file.string());
}

std::filesystem::path previous_checkpoint(const std::filesystem::path& path) {
  std::filesystem::path previous = path;
  previous += ".previous";
  return previous;
}

State read_checkpoint(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool folder = std::filesystem::is_directory(path, ignored);
  const std::filesystem::path newest = folder ? path / "checkpoint" : path;
  const std::filesystem::path previous = previous_checkpoint(newest);
  std::string complaint;
  try {
    return read_saved_run(newest).checkpoint.state;
  } catch (const InputError& error) {
    if (!std::filesystem::exists(previous, ignored)) throw;
    complaint = error.what();
  }
  try {
    return read_saved_run(previous).checkpoint.state;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}; {}", complaint, error.what()));
  }
}

void CheckpointFile::begin(const RunModel& model) {
  identity_.model = model_hash(*model.network, *model.bodies);
}

// What is not durable may take the place of its like only, or of what is kept as the one before.
void CheckpointFile::save(const Checkpoint& saved, bool durable) {
  const std::string bytes = encode_checkpoint({identity_, saved});
  if (newest_is_durable_) {
    replace_keeping(path_, previous_checkpoint(path_), bytes, durable);
  } else if (durable) {
    write_atomically(path_, bytes);
  } else {
    write_replacing(path_, bytes);
  }
  newest_is_durable_ = durable;
}

}  // namespace retiarius

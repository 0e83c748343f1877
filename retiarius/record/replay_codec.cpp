#include "retiarius/record/replay_codec.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/record/replay_chunk.hpp"

namespace retiarius {

namespace {

constexpr int kNothing = 0, kHold = 1, kLine = 2, kDerived = 3, kNeighbour = 8;
constexpr std::size_t kFixedBytes = 20;

// Sums and differences wrap, as readers in other languages can do too.
std::int32_t plus(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
std::int32_t minus(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
std::uint32_t folded(std::int32_t r) {
  return (static_cast<std::uint32_t>(r) << 1) ^ static_cast<std::uint32_t>(r >> 31);
}
std::int32_t unfolded(std::uint32_t n) {
  return static_cast<std::int32_t>(n >> 1) ^ -static_cast<std::int32_t>(n & 1u);
}

std::vector<std::uint32_t> residuals(const std::vector<std::int32_t>& codes,
                                     const std::vector<std::int32_t>& base, bool neighbour) {
  std::vector<std::uint32_t> result(codes.size());
  std::int32_t before = 0;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const std::int32_t r = minus(codes[k], base[k]);
    result[k] = folded(neighbour ? minus(r, before) : r);
    before = r;
  }
  return result;
}

// About how many bits the residuals need.
std::uint64_t cost(const std::vector<std::uint32_t>& residuals) {
  std::uint64_t bits = 0;
  for (std::uint32_t r : residuals) bits += static_cast<std::uint64_t>(std::bit_width(r));
  return bits;
}

// Method and count of planes, then the planes; each of these is a part of its own.
void append_planes(std::vector<std::string>& parts, int method,
                   const std::vector<std::uint32_t>& residuals) {
  std::uint32_t all = 0;
  for (std::uint32_t r : residuals) all |= r;
  const int planes = (std::bit_width(all) + 7) / 8;
  parts.push_back({static_cast<char>(method), static_cast<char>(planes)});
  for (int p = 0; p < planes; ++p) {
    std::string& plane = parts.emplace_back();
    plane.reserve(residuals.size());
    for (std::uint32_t r : residuals) plane += static_cast<char>((r >> (8 * p)) & 0xffu);
  }
}

// One stream in which long parts are coded apart, short ones with what follows them.
std::string deflated_parts(const std::vector<std::string>& parts) {
  constexpr std::size_t kLong = 2000;
  std::vector<std::string> joined(1);
  for (const std::string& part : parts) {
    if (part.size() >= kLong && joined.back().size() >= kLong) joined.emplace_back();
    joined.back() += part;
  }
  return deflated(std::vector<std::string_view>(joined.begin(), joined.end()));
}

// Bytes of an inflated frame, taken one piece after another.
class Pieces {
 public:
  explicit Pieces(std::string_view bytes) : bytes_(bytes) {}

  std::string_view take(std::size_t size) {
    if (bytes_.size() < size) throw InputError("the recording is damaged: a frame is too short");
    const std::string_view piece = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return piece;
  }
  int byte() { return static_cast<unsigned char>(take(1)[0]); }
  template <class T>
  T number() {
    T value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};

std::int32_t quantised(double x, double quantum, std::size_t node) {
  const double steps = std::floor(x / quantum + 0.5);
  if (!(std::abs(steps) < std::numeric_limits<std::int32_t>::max()))
    throw RunError(
        fmt::format("node {} is at {} m, which a recording of steps of {:.3g} m cannot "
                    "hold",
                    node, x, quantum));
  return static_cast<std::int32_t>(steps);
}

std::int32_t coded(const Minifloat& scale, double value, const char* what, std::size_t place) {
  if (!std::isfinite(value))
    throw RunError(
        fmt::format("the {} of number {} is {}, which cannot be recorded", what, place, value));
  return scale.code(value);
}

void append_bodies(std::string& bytes, const std::vector<BodyState>& bodies) {
  for (const BodyState& b : bodies) {
    for (double c : b.position) append_bytes(bytes, static_cast<float>(c));
    for (double c : b.attitude.coeffs()) append_bytes(bytes, static_cast<float>(c));
  }
}

BodyState read_body(Pieces& pieces) {
  BodyState body;
  for (double& c : body.position) c = pieces.number<float>();
  for (double& c : body.attitude.coeffs()) c = pieces.number<float>();
  return body;
}

}  // namespace

ReplayCodec::ReplayCodec(ReplayShape shape, const ReplayScales& scales)
    : shape_(std::move(shape)), scales_(scales) {}

std::size_t ReplayCodec::length(int sequence) const {
  return sequence == kTension || sequence == kStrain ? shape_.axial_stiffness.size() : shape_.nodes;
}

ReplayCodec::Codes ReplayCodec::codes_of(int sequence, const ReplayFrame& frame) const {
  const std::size_t count = length(sequence);
  Codes codes(count);
  const auto convert = [&](const std::vector<double>& values, const Minifloat& scale,
                           const char* what) {
    if (values.size() != count)
      throw Error(fmt::format("a frame has {} values of {} where {} are expected", values.size(),
                              what, count));
    for (std::size_t k = 0; k < count; ++k) codes[k] = coded(scale, values[k], what, k);
  };
  switch (sequence) {
    case kTension:
      convert(frame.tension, scales_.tension, "tension");
      break;
    case kStrain:
      convert(frame.strain, scales_.strain, "strain");
      break;
    case kCurvature:
      convert(frame.curvature, scales_.curvature, "curvature");
      break;
    case kSpeed:
      convert(frame.speed, scales_.speed, "speed");
      break;
    default:
      if (frame.x.size() != count)
        throw Error(fmt::format("a frame has {} nodes of {}", frame.x.size(), count));
      for (std::size_t k = 0; k < count; ++k)
        codes[k] = quantised(frame.x[k][sequence], scales_.quantum, k);
  }
  return codes;
}

std::int32_t ReplayCodec::slack_strain(std::size_t segment,
                                       const std::array<Codes, kSequences>& codes) const {
  const auto [a, b] = shape_.ends[segment];
  double square = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double d =
        minus(codes[axis][static_cast<std::size_t>(b)], codes[axis][static_cast<std::size_t>(a)]);
    square += d * d;
  }
  return scales_.strain.code(std::sqrt(square) * scales_.quantum / shape_.rest_length[segment] -
                             1.0);
}

ReplayCodec::Codes ReplayCodec::derived(int sequence, double time,
                                        const std::array<Codes, kSequences>& codes) const {
  Codes result(length(sequence), 0);
  const Codes& last = memory_[static_cast<std::size_t>(sequence)].last;
  if (sequence == kStrain) {
    const Codes& tension = codes[kTension];
    const Codes& tension_before = memory_[kTension].last;
    for (std::size_t k = 0; k < result.size(); ++k) {
      const double stiffness = shape_.axial_stiffness[k];
      if (tension[k] != 0 && stiffness > 0.0)
        result[k] = scales_.strain.code(scales_.tension.value(tension[k]) / stiffness);
      else if (since_key_ > 0 && tension_before[k] == 0)
        result[k] = last[k];
      else
        result[k] = slack_strain(k, codes);
    }
  }
  if (sequence == kSpeed && since_key_ > 0 && time > time_) {
    const double scale = scales_.quantum / (time - time_);
    for (std::size_t k = 0; k < result.size(); ++k) {
      double square = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double d = minus(codes[axis][k], memory_[axis].last[k]);
        square += d * d;
      }
      const double mean = std::sqrt(square) * scale;
      result[k] = scales_.speed.code(std::max(0.0, 2.0 * mean - scales_.speed.value(last[k])));
    }
  }
  return result;
}

ReplayCodec::Codes ReplayCodec::predicted(int sequence, int method, const Codes& derived) const {
  const Memory& memory = memory_[static_cast<std::size_t>(sequence)];
  const int kind = method & 7;
  if (kind == kHold) return memory.last;
  if (kind == kDerived) return derived;
  Codes base(length(sequence), 0);
  if (kind == kLine)
    for (std::size_t k = 0; k < base.size(); ++k)
      base[k] = plus(memory.last[k], minus(memory.last[k], memory.before[k]));
  return base;
}

std::vector<int> ReplayCodec::methods(int sequence) const {
  std::vector<int> kinds = {kNothing};
  if (since_key_ > 0) kinds.push_back(kHold);
  if (since_key_ > 1) kinds.push_back(kLine);
  if (sequence == kStrain || (sequence == kSpeed && since_key_ > 0)) kinds.push_back(kDerived);
  std::vector<int> result;
  for (int kind : kinds)
    for (int flag : {0, kNeighbour}) result.push_back(kind | flag);
  return result;
}

void ReplayCodec::remember(std::array<Codes, kSequences> codes, std::vector<std::uint8_t> touch,
                           double time) {
  for (std::size_t s = 0; s < kSequences; ++s) {
    memory_[s].before = std::move(memory_[s].last);
    memory_[s].last = std::move(codes[s]);
  }
  touch_ = std::move(touch);
  time_ = time;
  ++number_;
  ++since_key_;
}

std::string ReplayCodec::encode(const ReplayFrame& frame) {
  if (frame.touch.size() != shape_.nodes || frame.bodies.size() != shape_.bodies)
    throw Error("a frame has other nodes or bodies than its recording");
  const bool key = number_ % kKeyInterval == 0;
  if (key) since_key_ = 0;
  std::string content;
  std::vector<std::string> parts;
  append_bytes(content, frame.time);
  append_bytes(content, number_);
  append_bytes(content, static_cast<std::int32_t>(frame.phase));
  append_bytes(content, static_cast<std::uint32_t>(key ? 0 : 1));
  append_bodies(content, frame.bodies);
  std::array<Codes, kSequences> codes;
  for (int s = 0; s < kSequences; ++s) {
    Codes& own = codes[static_cast<std::size_t>(s)];
    own = codes_of(s, frame);
    const Codes from_others = derived(s, frame.time, codes);
    std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
    int best = kNothing;
    std::vector<std::uint32_t> kept;
    for (int method : methods(s)) {
      std::vector<std::uint32_t> r =
          residuals(own, predicted(s, method, from_others), (method & kNeighbour) != 0);
      const std::uint64_t bits = cost(r);
      if (bits >= least) continue;
      least = bits;
      best = method;
      kept = std::move(r);
    }
    append_planes(parts, best, kept);
  }
  std::string& touch = parts.emplace_back();
  for (std::size_t k = 0; k < shape_.nodes; ++k)
    touch += static_cast<char>(frame.touch[k] ^ (key ? 0 : touch_[k]));
  content += deflated_parts(parts);
  remember(std::move(codes), frame.touch, frame.time);
  return content;
}

ReplayFrame ReplayCodec::decode(std::string_view content) {
  Pieces head(content);
  ReplayFrame frame;
  frame.time = head.number<double>();
  const auto number = head.number<std::uint32_t>();
  frame.phase = head.number<std::int32_t>();
  const bool key = head.number<std::uint32_t>() == 0;
  if (!key && (number != number_ || since_key_ == 0))
    throw InputError(fmt::format("frame {} does not follow frame {}", number, number_));
  number_ = number;
  if (key) since_key_ = 0;
  for (std::size_t k = 0; k < shape_.bodies; ++k) frame.bodies.push_back(read_body(head));
  const std::string stream = inflated(head.rest());
  // Each node has a byte at the end: without them, no memory is taken for what a header claims.
  if (stream.size() < shape_.nodes) Pieces(stream).take(shape_.nodes);
  Pieces pieces(stream);
  std::array<Codes, kSequences> codes;
  for (int s = 0; s < kSequences; ++s) {
    Codes& own = codes[static_cast<std::size_t>(s)];
    own.resize(length(s));
    const int method = pieces.byte(), planes = pieces.byte();
    const std::vector<int> known = methods(s);
    if (planes > 4 || std::find(known.begin(), known.end(), method) == known.end())
      throw InputError("the recording is damaged: a frame uses an unknown method");
    std::vector<std::uint32_t> r(own.size(), 0);
    for (int p = 0; p < planes; ++p) {
      const std::string_view plane = pieces.take(own.size());
      for (std::size_t k = 0; k < own.size(); ++k)
        r[k] |= static_cast<std::uint32_t>(static_cast<unsigned char>(plane[k])) << (8 * p);
    }
    const Codes base = predicted(s, method, derived(s, frame.time, codes));
    std::int32_t before = 0;
    for (std::size_t k = 0; k < own.size(); ++k) {
      before = plus(unfolded(r[k]), (method & kNeighbour) != 0 ? before : 0);
      own[k] = plus(base[k], before);
    }
  }
  for (char c : pieces.take(shape_.nodes)) frame.touch.push_back(static_cast<std::uint8_t>(c));
  if (!key)
    for (std::size_t k = 0; k < shape_.nodes; ++k) frame.touch[k] ^= touch_[k];
  for (std::size_t k = 0; k < shape_.nodes; ++k) {
    frame.x.emplace_back(codes[kX][k], codes[kY][k], codes[kZ][k]);
    frame.x.back() *= scales_.quantum;
    frame.curvature.push_back(scales_.curvature.value(codes[kCurvature][k]));
    frame.speed.push_back(scales_.speed.value(codes[kSpeed][k]));
  }
  for (std::size_t k = 0; k < shape_.axial_stiffness.size(); ++k) {
    frame.tension.push_back(scales_.tension.value(codes[kTension][k]));
    frame.strain.push_back(scales_.strain.value(codes[kStrain][k]));
  }
  remember(std::move(codes), frame.touch, frame.time);
  return frame;
}

}  // namespace retiarius

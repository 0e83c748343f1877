// One instant of a recording as few bytes, and back.
//
// Content of a FRAM chunk: time (64-bit float, s), number of the frame from 0 (32 bits), phase
// (32 bits), kind (one byte: 0 key frame, 1 difference), three bytes of zero; for every body its
// position and its attitude as a quaternion x, y, z, w (seven 32-bit floats); then a zlib stream.
//
// Inflated, the stream holds eight sequences, one after another: x, y, z, tension, strain,
// curvature, speed, contact. The first seven are signed integers, one a node or segment: multiples
// of the header's quantum (x, y, z), or codes (Minifloat). A sequence is one byte of method, one
// byte that counts planes, and that many planes of one byte an element, lowest first, which
// together are the elements' residuals r as 2r or, for r < 0, -2r - 1. The method's lower bits say
// what is predicted: 0 nothing, 1 the element of the previous frame, 2 the straight line through
// the previous two frames, 3 what follows from other sequences; with bit 3 the residual of the
// element before is predicted too. A key frame uses no other frame.
//
// What follows from others: strain, from the decoded tension where that is not zero and the axial
// stiffness is positive, as tension / axial stiffness; of a slack segment from the previous frame
// if it was slack then too, else from the decoded positions, as length / rest length - 1. Speed,
// from the previous frame's speed and the mean speed since, as 2 mean - previous, not below 0.
//
// Contact is one byte a node, 0 none, 1 slides, 2 sticks, xor the previous frame's.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/record/minifloat.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// What a recording keeps of one instant.
struct ReplayFrame {
  double time = 0.0;  // s
  Index phase = 0;
  std::vector<Vec3> x;              // m
  std::vector<double> tension;      // of each segment, N
  std::vector<double> strain;       // of each segment
  std::vector<double> curvature;    // at each node, 1/m
  std::vector<double> speed;        // of each node, m/s
  std::vector<std::uint8_t> touch;  // of each node: 0 none, 1 slides, 2 sticks
  std::vector<BodyState> bodies;    // poses; velocities are not kept
};

// How numbers are rounded; the same in a whole recording.
struct ReplayScales {
  double quantum = 1.0;  // m, of positions: the error is at most half of it along each axis
  Minifloat tension, strain, curvature, speed;
};

struct ReplayShape {
  std::size_t nodes = 0;
  std::size_t bodies = 0;
  std::vector<double> axial_stiffness;     // EA of each segment, N
  std::vector<std::array<Index, 2>> ends;  // nodes of each segment
  std::vector<double> rest_length;         // of each segment, m
};

// Keeps the last two frames, from which the next is predicted. One object either encodes or
// decodes.
class ReplayCodec {
 public:
  static constexpr std::uint32_t kKeyInterval = 64;  // frames

  ReplayCodec(ReplayShape shape, const ReplayScales& scales);

  // The content of the next frame's chunk. Throws RunError that names what cannot be written: a
  // number that is not finite, or a node farther away than 2^31 quanta.
  std::string encode(const ReplayFrame& frame);

  // Frames must come in order from a key frame on. Throws InputError.
  ReplayFrame decode(std::string_view content);

 private:
  enum Sequence { kX, kY, kZ, kTension, kStrain, kCurvature, kSpeed, kSequences };
  struct Memory {
    std::vector<std::int32_t> last, before;
  };
  using Codes = std::vector<std::int32_t>;

  std::size_t length(int sequence) const;
  Codes codes_of(int sequence, const ReplayFrame& frame) const;
  std::int32_t slack_strain(std::size_t segment, const std::array<Codes, kSequences>& codes) const;
  Codes derived(int sequence, double time, const std::array<Codes, kSequences>& codes) const;
  Codes predicted(int sequence, int method, const Codes& derived) const;
  std::vector<int> methods(int sequence) const;
  void remember(std::array<Codes, kSequences> codes, std::vector<std::uint8_t> touch, double time);

  ReplayShape shape_;
  ReplayScales scales_;
  std::array<Memory, kSequences> memory_;
  std::vector<std::uint8_t> touch_;
  double time_ = 0.0;
  std::uint32_t number_ = 0;  // of the next frame
  int since_key_ = 0;         // frames in memory_, counted from the key frame
};

}  // namespace retiarius

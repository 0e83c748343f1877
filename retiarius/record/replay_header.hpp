// What a recording says once, before its frames: HEAD, the first chunk.
//
// Content: the 32-bit size of a JSON text, the text, and a zlib stream of arrays. The text has
//   title, program            of the mission; what wrote the file
//   nodes, segments           counts
//   size                      m, the largest extent of the net as designed
//   quantum, error            m, step of the positions and their largest error along each axis
//   key_interval              frames from one key frame to the next
//   channels                  in the order of the frames' sequences: name, unit, on (segment,
//   node),
//                             and quantum and steps as in Minifloat
//   materials                 radius (m), axial_stiffness (N), line_density (kg/m)
//   corners, bullets          nodes; each bullet with node, mass (kg), radius (m)
//   phases                    name and kind
//   bodies                    name
//   arrays                    in the order of the zlib stream: name, type (u32, f32, f64), shape
// Arrays: segments (two nodes each), material and rest_length (m) of each segment, mass (kg) of
// each node, knots, perimeter, and for body k bodyK.vertices (m, body axes) and bodyK.triangles.
#pragma once

#include <string>

#include "retiarius/mission/observer.hpp"
#include "retiarius/record/replay_codec.hpp"

namespace retiarius {

// Largest error of a recorded coordinate, in sizes of the net.
inline constexpr double kReplayError = 2e-5;

ReplayShape replay_shape(const RunModel& model);
ReplayScales replay_scales(const RunModel& model);

// `version` is the program's.
std::string replay_header(const RunModel& model, const std::string& version);

// The header's JSON text, and what the codec needs of it. Throws InputError.
struct ReplayHeader {
  std::string text;
  ReplayShape shape;
  ReplayScales scales;
};
ReplayHeader read_replay_header(std::string_view content);

}  // namespace retiarius

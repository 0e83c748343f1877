// A mission: the whole description of one run, as plain validated data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "retiarius/base/error.hpp"
#include "retiarius/base/vec.hpp"
#include "retiarius/bodies/spec.hpp"
#include "retiarius/contact/spec.hpp"
#include "retiarius/forces/spec.hpp"
#include "retiarius/motion/spec.hpp"
#include "retiarius/net/spec.hpp"

namespace retiarius {

enum class PhaseKind { free, fold, shoot, spread, contact, close };
enum class ClosePath { behind, straight };

// [[phase.move]]: prescribed motion of nodes, on top of what the phase's kind prescribes. The nodes
// move by `displacement` within `duration` (smoothly, at rest at both ends) or at a constant
// `velocity` for `duration`; afterwards they are held until the phase ends.
struct MoveSpec {
  std::vector<std::string> nodes;    // required
  Vec3 displacement = Vec3::Zero();  // m
  Vec3 velocity = Vec3::Zero();      // m/s
  double duration = kInfinity;       // s; required with displacement
};

struct PhaseSpec {
  PhaseKind kind = PhaseKind::free;  // required
  std::string name;                  // default: the kind
  std::vector<std::string> fix;      // names of nodes held where they are; a string or a list
  std::string until;                 // trigger expression; required
  std::vector<MoveSpec> move;

  // kind = "shoot"; each list has one value for all corners or one per corner.
  std::vector<double> speed;           // m/s; required
  std::vector<double> half_angle_deg;  // from the axis; default 45
  std::vector<double> delay;  // s; shoot: of each corner (held until then); close: one value
  Vec3 axis = Vec3::UnitZ();  // of the shot

  // kind = "fold"
  std::vector<std::string> grips;  // "lattice", "spokes", or names of nodes; default "lattice"
  double grip_spacing = 0.0;       // m between neighbouring grips; required unless grips are named
  double ratio = 0.1;              // final over initial distance between neighbouring grips
  double duration = 0.0;           // s of the folding; required

  // kind = "close"
  ClosePath path = ClosePath::behind;  // past the target and inward; straight: to its centre
  double distance = 0.0;               // m behind the target's mass centre along the shot axis
  double radius = 0.0;       // m from the axis (straight: from the centre) where corners stop
  double close_speed = 1.0;  // m/s along the path, key `speed`

  // The mission's tables with this phase's overrides applied.
  EnvironmentSpec environment;
  IntegratorSpec integrator;
  ContactSpec contact;
  SourcePlace place;  // of the phase's table, for messages
};

struct ProbeSpec {
  std::string name;
  std::string node;  // a name that selects one node, or an index
  SourcePlace place;
};

struct OutputSpec {
  double interval = 0.01;        // s, history; must be a multiple of the step
  double frame_interval = 0.05;  // s, frames; a multiple of interval
  bool every_step = false;       // a frame of every accepted step as well
};

struct Mission {
  std::string title;
  std::uint64_t seed = 0;  // of everything random
  NetSpec net;
  std::vector<BodySpec> targets;
  EnvironmentSpec environment;
  IntegratorSpec integrator;
  ContactSpec contact;
  std::vector<PhaseSpec> phases;
  std::vector<ProbeSpec> probes;
  OutputSpec output;
  std::string file;    // where it was read from; empty for text
  std::string folder;  // that relative paths in it start from
};

}  // namespace retiarius

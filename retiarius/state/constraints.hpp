// Blocked directions of nodes: prescribed motion, grips and contact are all this one thing.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"

namespace retiarius {

// Along the blocked directions the node's end position is prescribed; a constraint attached to a
// free body prescribes it relative to that body, which then takes the reaction.
struct Constraint {
  Index node = kNone;
  Mat3 blocked = Mat3::Identity();  // orthogonal projector on the blocked directions
  Vec3 target = Vec3::Zero();       // end position; only its blocked part counts, m
  Index body = kNone;               // free body that the target moves with
  Vec3 lever = Vec3::Zero();        // from the body's predicted mass centre to the point, m
  // Friction of a node that slides along the directions that are not blocked: at most `limit` (N)
  // against its slip relative to `carried`, the place that moves with the body; slips below
  // `smoothing` (m) get proportionately less, so that the force is smooth.
  double limit = 0.0;
  Vec3 carried = Vec3::Zero();
  double smoothing = 0.0;
};

// Nodes whose motion is prescribed over a step, with position and velocity at its end.
struct Prescribed {
  Index node = kNone;
  Vec3 position = Vec3::Zero();  // m
  Vec3 velocity = Vec3::Zero();  // m/s
};

}  // namespace retiarius

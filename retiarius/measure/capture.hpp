// How much of a target the net holds.
#pragma once

#include <optional>
#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/measure/hull.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

struct Capture {
  double share = 0.0;          // of the target's surface area inside the hull of the nodes
  bool center_inside = false;  // its mass centre is inside the hull
};

// Of a body at its pose by a net with the given nodes (m). Absent for a plane, which has no surface
// to be inside of. A net that lies flat in a plane holds nothing.
std::optional<Capture> measure_capture(const Body& target, const BodyState& pose,
                                       const std::vector<Vec3>& nodes);

// The same where the hull of the nodes is at hand.
std::optional<Capture> measure_capture(const Body& target, const BodyState& pose,
                                       const std::vector<Vec3>& nodes,
                                       const std::optional<ConvexHull>& hull);

}  // namespace retiarius

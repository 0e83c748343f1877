// The step up to which an explicit scheme is stable.
#pragma once

#include "retiarius/net/network.hpp"

namespace retiarius {

// A step, s, at which the explicit integrator is surely stable for straight taut threads, and the
// segment that sets it: the smallest over the nodes of the h that solves
//
//   h^2 sum k + 4 h sum k tau = 2 m
//
// with the sums over what meets in a node of mass m (Gershgorin's bound): the axial stiffnesses
// k = EA / l0 with the threads' material damping tau, and of each joint
// EI |c| (|c_a| + |c_b| + |c_c|) / (2 lv) with c the node's weight in the difference of the joint's
// slopes. Without damping and bending it is 2 / omega with omega^2 = 2 sum k / m. Infinite, and no
// segment, for a net without segments.
struct StableStep {
  double step = 0.0;
  Index segment = kNone;
};
StableStep stable_explicit_step(const Network& network);

}  // namespace retiarius

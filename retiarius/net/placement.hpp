// Where the nodes of a net stand when the mission starts.
#pragma once

#include "retiarius/net/network.hpp"

namespace retiarius {

// Fills `initial` from `design` (scale and zigzag about the origin, then `position`) and sets the
// velocities to zero. Rest lengths stay.
//
// Zigzag: nodes at odd graph distance from corner 0 are lifted along +z by sqrt(l0^2 - d^2), d
// being the distance of a segment's nodes in the scaled plane, so that every segment keeps its
// rest length l0. Throws InputError where that is impossible: the graph is not bipartite or not
// connected, or the segments of one node ask for different lifts.
void place_nodes(Network& network, const NetSpec& spec);

}  // namespace retiarius

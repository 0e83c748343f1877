// Static equilibrium of threads built by hand.
#pragma once

#include <vector>

#include "retiarius/net/network.hpp"
#include "retiarius/state/state.hpp"
#include "verification/framework/context.hpp"

namespace retiarius::verification {

// At rest under gravity (m/s2) with the nodes of `held` where the net has them at first; positions
// and the supports' forces. The net is changed where the present fault says so. Throws RunError.
State equilibrium(const Context& context, Network net, const Vec3& gravity,
                  const std::vector<Index>& held, double tolerance = 1e-8);

// Makes a thread weigh nothing but `load` (kg) at one node: under 1 m/s2 a point force in N. The
// other nodes keep 1e-12 of it, as masses must be positive.
void load_only(Network& net, Index node, double load);

// The thread of `net`, straight or not, laid along an arc of circle between points `span` apart
// along x that hangs below them: as long as it was, nearly.
void lay_on_arc(Network& net, double span);

}  // namespace retiarius::verification

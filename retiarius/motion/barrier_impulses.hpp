// What barrier contacts do to bodies at the end of a step, and the energy that friction takes.
#pragma once

#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/contact/barrier.hpp"
#include "retiarius/state/state.hpp"
#include "retiarius/state/step.hpp"

namespace retiarius {

// Gives the bodies the impulses of the solved contacts, fills `now.touches` (threads on bodies) and
// books friction's loss and the impulses of fixed bodies. The nodes have their part already.
void apply_barrier_impulses(const Step& step, const std::vector<Body>& bodies, double stick_speed,
                            const std::vector<PairContact>& contacts, State& now);

// Of the contacts on each node at the stage, N.
void node_forces(const std::vector<PairContact>& contacts, std::size_t nodes,
                 std::vector<Vec3>& force);

}  // namespace retiarius

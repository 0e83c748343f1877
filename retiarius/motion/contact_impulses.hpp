// What contacts do to velocities at the end of a step, and the energy they take.
#pragma once

#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/contact/response.hpp"
#include "retiarius/state/state.hpp"
#include "retiarius/state/step.hpp"

namespace retiarius {

// Transfers the reactions of a solved step to the bodies and completes the plastic impact: a
// touching node leaves the step with the body's velocity along its blocked directions. All impulses
// come in pairs, node and body, so that linear momentum is kept to round-off.
//
// `now` holds end positions and the velocities that the integrator gives; it is completed here.
// force: of each contact on its node at the stage, N, in the order of `contacts`.
void apply_contact_impulses(const Step& step, const std::vector<Body>& bodies,
                            const std::vector<double>& mass, double friction,
                            const std::vector<SolvedContact>& contacts,
                            const std::vector<Vec3>& force, State& now);

}  // namespace retiarius

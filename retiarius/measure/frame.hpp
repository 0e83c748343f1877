// What is drawn of a simulation's present state.
#pragma once

#include "retiarius/measure/history.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius {

// Axial strain of each segment at positions x.
std::vector<double> strains(const Network& network, const std::vector<Vec3>& x);

// Refers to the simulation's state, which must live as long as the frame.
Frame make_frame(const Simulation& simulation, Index phase);

}  // namespace retiarius

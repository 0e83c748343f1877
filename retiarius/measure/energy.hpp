// Energies of net and bodies that follow from the present state.
#pragma once

#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// Kinetic energy of nodes and free bodies, spin included, J.
double kinetic_energy(const Network& network, const std::vector<Body>& bodies, const State& state);

// Sum of mass times place of nodes and free bodies, kg m.
Vec3 first_moment(const Network& network, const std::vector<Body>& bodies, const State& state);

// Energy of nodes and free bodies in uniform gravity g (m/s2), -sum m g.x: zero at the origin, J.
double gravity_energy(const Network& network, const std::vector<Body>& bodies, const State& state,
                      const Vec3& g);

}  // namespace retiarius

#include "retiarius/measure/energy.hpp"

namespace retiarius {

double kinetic_energy(const Network& network, const std::vector<Body>& bodies, const State& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.v.size(); ++i)
    sum += 0.5 * network.mass[i] * state.v[i].squaredNorm();
  for (std::size_t b = 0; b < bodies.size(); ++b) sum += kinetic_energy(bodies[b], state.bodies[b]);
  return sum;
}

Vec3 first_moment(const Network& network, const std::vector<Body>& bodies, const State& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < state.x.size(); ++i) sum += network.mass[i] * state.x[i];
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (!bodies[b].fixed) sum += bodies[b].mass * state.bodies[b].position;
  return sum;
}

double gravity_energy(const Network& network, const std::vector<Body>& bodies, const State& state,
                      const Vec3& g) {
  return -g.dot(first_moment(network, bodies, state));
}

}  // namespace retiarius

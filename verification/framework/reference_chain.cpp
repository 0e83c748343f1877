#include "verification/framework/reference_chain.hpp"

#include <cmath>

namespace retiarius::verification {

namespace {

std::vector<Vec3> moved(const std::vector<Vec3>& from, const std::vector<Vec3>& rate, double time) {
  std::vector<Vec3> to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += time * rate[i];
  return to;
}

}  // namespace

ReferenceChain::ReferenceChain(const Network& network)
    : x(network.initial), v(network.velocity), mass(network.mass) {
  const Material& m = network.materials.front();
  for (const Segment& s : network.segments) rest.push_back(s.rest_length);
  axial = m.axial_stiffness;
  bending = m.bending_stiffness;
  tangent = m.bending == Bending::tangent;
  tau = m.damping;
}

// The moment of a joint turns its two segments towards each other: each end of a segment of length
// l gets M / l across it. With the angle phi between the segments the energy EI kappa^2 / (2 d) has
// the derivative M = EI sin(phi) / d, or 4 EI tan(phi/2) / (d (1 + cos(phi))) for the tangent.
std::vector<Vec3> ReferenceChain::acceleration(const std::vector<Vec3>& places,
                                               const std::vector<Vec3>& velocities) const {
  std::vector<Vec3> force(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    force[i] = mass[i] * (gravity - mu * velocities[i]);
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const Vec3 along = (places[k + 1] - places[k]).normalized();
    const double length = (places[k + 1] - places[k]).norm();
    const double rate = along.dot(velocities[k + 1] - velocities[k]);
    const Vec3 pull = axial * ((length - rest[k] + tau * rate) / rest[k]) * along;
    force[k] += pull;
    force[k + 1] -= pull;
  }
  for (std::size_t k = 1; bending > 0.0 && k + 1 < places.size(); ++k) {
    const Vec3 before = places[k] - places[k - 1], after = places[k + 1] - places[k];
    const Vec3 axis = before.cross(after);
    const double sine = axis.norm() / (before.norm() * after.norm());
    if (sine == 0.0) continue;
    const double cosine = before.dot(after) / (before.norm() * after.norm());
    const double span = 0.5 * (rest[k - 1] + rest[k]);
    const double moment =
        bending / span * (tangent ? 4.0 * sine / ((1.0 + cosine) * (1.0 + cosine)) : sine);
    const Vec3 turn = moment * axis.normalized();
    const Vec3 first = turn.cross(before) / before.squaredNorm();
    const Vec3 second = turn.cross(after) / after.squaredNorm();
    force[k - 1] -= first;
    force[k] += first + second;
    force[k + 1] -= second;
  }
  for (std::size_t i = 0; i < force.size(); ++i) force[i] /= mass[i];
  for (Index i : held) force[static_cast<std::size_t>(i)].setZero();
  return force;
}

void ReferenceChain::advance(double duration, int steps) {
  const double h = duration / steps;
  for (int n = 0; n < steps; ++n) {
    const std::vector<Vec3> a1 = acceleration(x, v);
    const std::vector<Vec3> v2 = moved(v, a1, 0.5 * h);
    const std::vector<Vec3> a2 = acceleration(moved(x, v, 0.5 * h), v2);
    const std::vector<Vec3> v3 = moved(v, a2, 0.5 * h);
    const std::vector<Vec3> a3 = acceleration(moved(x, v2, 0.5 * h), v3);
    const std::vector<Vec3> v4 = moved(v, a3, h);
    const std::vector<Vec3> a4 = acceleration(moved(x, v3, h), v4);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += h / 6.0 * (v[i] + 2.0 * v2[i] + 2.0 * v3[i] + v4[i]);
      v[i] += h / 6.0 * (a1[i] + 2.0 * a2[i] + 2.0 * a3[i] + a4[i]);
    }
  }
}

}  // namespace retiarius::verification

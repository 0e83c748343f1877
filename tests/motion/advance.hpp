// Runs simulations for tests, and what they conserve.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius::testing {

inline std::vector<Prescribed> held_at(const std::vector<Vec3>& x,
                                       const std::vector<Index>& nodes) {
  std::vector<Prescribed> result;
  for (Index i : nodes) result.push_back({i, x[i], Vec3::Zero()});
  return result;
}

inline PrescribedMotion hold(const std::vector<Vec3>& x, const std::vector<Index>& nodes) {
  return [held = held_at(x, nodes)](double) { return held; };
}

// Advances to step k = 1..count with time k h; calls each() after every whole step.
template <typename Each>
void run(Simulation& sim, double h, int count, const PrescribedMotion& motion, Each each) {
  const double from = sim.state().time;
  for (int k = 1; k <= count; ++k) {
    const double end = from + k * h;
    while (sim.state().time < end) sim.advance(end, motion);
    each(k);
  }
}

inline void run(Simulation& sim, double h, int count, const PrescribedMotion& motion = {}) {
  run(sim, h, count, motion, [](int) {});
}

inline Vec3 linear_momentum(const Simulation& sim) {
  Vec3 p = Vec3::Zero();
  const State& s = sim.state();
  for (std::size_t i = 0; i < s.v.size(); ++i) p += sim.network().mass[i] * s.v[i];
  for (std::size_t b = 0; b < s.bodies.size(); ++b)
    if (!sim.bodies()[b].fixed) p += sim.bodies()[b].mass * s.bodies[b].velocity;
  return p;
}

// About the origin.
inline Vec3 angular_momentum(const Simulation& sim) {
  Vec3 l = Vec3::Zero();
  const State& s = sim.state();
  for (std::size_t i = 0; i < s.v.size(); ++i) l += sim.network().mass[i] * s.x[i].cross(s.v[i]);
  for (std::size_t b = 0; b < s.bodies.size(); ++b) {
    const Body& body = sim.bodies()[b];
    if (body.fixed) continue;
    const BodyState& p = s.bodies[b];
    l += body.mass * p.position.cross(p.velocity) + p.angular_momentum;
  }
  return l;
}

// Sum of m |v| of everything that moves, the scale of linear momentum.
inline double momentum_scale(const Simulation& sim) {
  double sum = 0.0;
  const State& s = sim.state();
  for (std::size_t i = 0; i < s.v.size(); ++i) sum += sim.network().mass[i] * s.v[i].norm();
  for (std::size_t b = 0; b < s.bodies.size(); ++b)
    if (!sim.bodies()[b].fixed) sum += sim.bodies()[b].mass * s.bodies[b].velocity.norm();
  return sum;
}

inline double kinetic_energy(const Simulation& sim) {
  double sum = 0.0;
  const State& s = sim.state();
  for (std::size_t i = 0; i < s.v.size(); ++i)
    sum += 0.5 * sim.network().mass[i] * s.v[i].squaredNorm();
  for (std::size_t b = 0; b < s.bodies.size(); ++b)
    sum += kinetic_energy(sim.bodies()[b], s.bodies[b]);
  return sum;
}

// Kinetic, elastic and gravity energy together.
inline double mechanical_energy(const Simulation& sim) {
  double sum = kinetic_energy(sim) + sim.stretching_energy() + sim.bending_energy();
  const Vec3 g = sim.environment().gravity;
  const State& s = sim.state();
  for (std::size_t i = 0; i < s.x.size(); ++i) sum -= sim.network().mass[i] * g.dot(s.x[i]);
  for (std::size_t b = 0; b < s.bodies.size(); ++b)
    if (!sim.bodies()[b].fixed) sum -= sim.bodies()[b].mass * g.dot(s.bodies[b].position);
  return sum;
}

// What the account explains of the energy's fall, J; the rest of the fall is the integrator's.
inline double accounted_loss(const State& s) {
  return s.account.material_loss + s.account.environment_loss + s.account.friction_loss +
         s.account.impact_loss - s.account.prescribed_work;
}

}  // namespace retiarius::testing

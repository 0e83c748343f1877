// One time step as the laws see it: where it starts, and how velocity and strain rate follow from
// the position that the step solves for.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// Every integrator solves for one stage position y, at which the laws are evaluated. The stage is
// the step's end (implicit Euler, Newmark) or its middle (midpoint).
struct Step {
  // How the rate of a strain follows from its values at start and stage.
  enum class StrainRate {
    backward,   // implicit Euler: (eps - eps0) rate
    trapezoid,  // Newmark: 2 (eps - eps0) / h - eps0', at the step's end
    midpoint,   // implicit midpoint: 2 (eps - eps0) / h plus the chord's curvature
    start,      // at the start itself, from its velocity
    none,       // static: no rate
  };

  const State* start = nullptr;  // x0, v0
  double h = 0.0;                // length of the step, s
  double rate = 0.0;             // 1/s: the stage velocity is w = rate (y - x0) - carry v0
  double carry = 0.0;
  double inertia = 0.0;  // 1/s2: the stage balances inertia m (y - predicted)
  double reach = 1.0;    // x1 = x0 + reach (y - x0)
  StrainRate strain_rate = StrainRate::backward;

  Vec3 stage_velocity(Index i, const Vec3& y) const {
    const auto k = static_cast<std::size_t>(i);
    return rate * (y - start->x[k]) - carry * start->v[k];
  }
  // Impulse over the whole step of a force that acts at the stage as a contact reaction does
  // (fully implicitly), N s per N.
  double reaction_impulse() const { return rate * reach / inertia; }
};

}  // namespace retiarius

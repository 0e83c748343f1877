// One time step as the laws see it: where it starts, and how velocity and strain rate follow from
// the position that the step solves for.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// Every integrator solves for one stage position y, at which the laws are evaluated. The stage is
// the step's end (implicit Euler, Newmark, each of the two of TR-BDF2), its middle (midpoint) or a
// place between (generalised alpha).
struct Step {
  // How the rate of a strain follows from its values at start and stage.
  enum class StrainRate {
    backward,   // implicit Euler: (eps - eps0) rate
    trapezoid,  // Newmark: 2 (eps - eps0) / h - eps0', at the step's end
    midpoint,   // implicit midpoint: 2 (eps - eps0) / h plus the chord's curvature
    predicted,  // exact where the start's velocity leads, linear in the strain from there
    start,      // at the start itself, from its velocity
    none,       // static: no rate
  };

  const State* start = nullptr;  // x0, v0
  double h = 0.0;                // length of the step, s
  double rate = 0.0;             // 1/s: the stage velocity is w = rate (y - x0) - carry v0 + drift
  double carry = 0.0;
  const std::vector<Vec3>* drift = nullptr;  // of each node, m/s; null: none
  double inertia = 0.0;                      // 1/s2: the stage balances inertia m (y - predicted)
  double reach = 1.0;                        // x1 = x0 + reach (y - x0)
  StrainRate strain_rate = StrainRate::backward;

  Vec3 stage_velocity(Index i, const Vec3& y) const {
    const auto k = static_cast<std::size_t>(i);
    const Vec3 w = rate * (y - start->x[k]) - carry * start->v[k];
    return drift ? Vec3(w + (*drift)[k]) : w;
  }
  // Impulse over the whole step of a force that acts at the stage as a contact reaction does
  // (fully implicitly), N s per N.
  double reaction_impulse() const { return rate * reach / inertia; }

  // Whether forces of the step act on later ones too. Laws then state outside impulses as h times
  // the force at the stage, from which the simulation takes this step's part, and losses by the
  // mean rates over the step.
  bool remembers() const { return strain_rate == StrainRate::predicted; }
};

}  // namespace retiarius

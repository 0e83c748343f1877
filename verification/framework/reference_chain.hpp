// Equations of motion of a thread of point masses, written anew for references and integrated by
// the classical Runge-Kutta scheme: shares nothing with the program's laws and integrators.
#pragma once

#include <functional>
#include <vector>

#include "retiarius/net/network.hpp"

namespace retiarius::verification {

struct ReferenceChain {
  // Takes places, velocities, masses and rest lengths of a network of one thread.
  explicit ReferenceChain(const Network& network);

  std::vector<Vec3> x, v;
  std::vector<double> mass, rest;
  double axial = 0.0;    // EA, N
  double bending = 0.0;  // EI, N m2
  bool tangent = false;  // curvature 2 tan(phi/2), else 2 sin(phi/2)
  double tau = 0.0;      // s
  double mu = 0.0;       // 1/s
  Vec3 gravity = Vec3::Zero();
  std::vector<Index> held;  // nodes that stay

  std::vector<Vec3> acceleration(const std::vector<Vec3>& places,
                                 const std::vector<Vec3>& velocities) const;
  // Advances by `steps` steps to time `duration` (s).
  void advance(double duration, int steps);
};

}  // namespace retiarius::verification

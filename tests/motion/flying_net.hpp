// A soft net that flies, turns and swings: all its threads are strained, none is held.
#pragma once

#include <cmath>

#include "retiarius/net/network.hpp"

namespace retiarius::testing {

// tau: material damping, s; bending: EI, N m2, 0: none.
inline Network flying_net(Pattern pattern, int segments, bool compression, double tau,
                          double bending) {
  NetSpec spec;
  spec.pattern = pattern;
  spec.side = 1.0;
  spec.mesh = 0.25;
  spec.segments = segments;
  spec.thread.young_modulus = 1e6;
  spec.thread.density = 1000.0;
  spec.thread.radius = 0.005;
  spec.thread.compression = compression;
  spec.thread.material_damping = tau;
  if (bending > 0.0) {
    spec.thread.bending = Bending::bounded;
    spec.thread.bending_stiffness = bending;
  }
  Network net = build_network(spec);
  for (std::size_t i = 0; i < net.initial.size(); ++i) {
    const Vec3 r = net.initial[i];
    net.velocity[i] = Vec3(0.3, -0.2, 3) + Vec3(1, 2, 3).cross(r) +
                      2.0 * Vec3(r.x() * r.y(), -r.y(), std::sin(9.0 * r.x()));
  }
  return net;
}

}  // namespace retiarius::testing

// What contact does to bodies and threads at the end of a step.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "retiarius/motion/simulation.hpp"

namespace retiarius {

// Of one body, by threads and other bodies.
struct BodyLoad {
  Vec3 force = Vec3::Zero();       // total, N
  std::optional<double> normal;    // sum of the normal forces' sizes, N; absent without barriers
  std::optional<double> friction;  // the same of friction, N
};

// Barrier contacts of a state by kind; zero with any other method.
struct ContactLoad {
  double energy = 0.0;  // of the barriers, J
  Index faces = 0;      // nodes on faces and planes
  Index edges = 0;      // segments on edges, corners and balls
  Index threads = 0;    // segments on segments
  Index bodies = 0;     // bodies on bodies
  std::vector<BodyLoad> loads;
};

ContactLoad contact_load(const Simulation& simulation);

}  // namespace retiarius

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

// One place of contact and what acts there: on the body by a thread, on the second thread by the
// first, on the second body by the first.
struct ContactMark {
  Vec3 point = Vec3::Zero();  // m
  Vec3 force = Vec3::Zero();  // N, friction included
  Index body = kNone;         // that the force acts on; kNone: a thread
  Index thread = kNone;       // that touches it (Network::threads); kNone: a body does
};

// Of the end of the last step, in the order of their pairs.
std::vector<ContactMark> contact_marks(const Simulation& simulation);

}  // namespace retiarius

// What a mission says about the surroundings ([environment]): plain data.
#pragma once

#include "retiarius/base/vec.hpp"

namespace retiarius {

struct EnvironmentSpec {
  Vec3 gravity = Vec3::Zero();  // m/s2
  double damping = 0.0;         // mu, 1/s, environmental
};

}  // namespace retiarius

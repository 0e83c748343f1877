// Reproducible random points for tests.
#pragma once

#include <random>

#include "retiarius/base/vec.hpp"

namespace retiarius::test {

class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : engine_(seed) {}

  double within(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0;
  }
  Vec3 in_cube(double half) {
    return Vec3(within(-half, half), within(-half, half), within(-half, half));
  }
  Vec3 direction() {
    while (true) {
      const Vec3 p = in_cube(1.0);
      if (p.norm() > 0.1 && p.norm() < 1.0) return p.normalized();
    }
  }

 private:
  std::mt19937 engine_;
};

}  // namespace retiarius::test

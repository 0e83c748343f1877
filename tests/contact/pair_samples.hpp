// Random and degenerate pairs of primitives.
#pragma once

#include <cmath>

#include "retiarius/base/random.hpp"
#include "retiarius/contact/contact_pair.hpp"

namespace retiarius::testing {

// A stream of random numbers; the n-th number depends on seed and n alone.
class Stream {
 public:
  explicit Stream(std::uint64_t seed) : seed_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * random_uniform(seed_, 0, counter_++);
  }
  int integer(int count) { return static_cast<int>(uniform(0.0, count)); }
  // Between the two, evenly on a logarithmic scale.
  double scale(double low, double high) {
    return low * std::exp(uniform(0.0, 1.0) * std::log(high / low));
  }
  Vec3 vector(double size = 1.0) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = vector();
      const double norm = v.norm();
      if (norm > 0.1 && norm <= 1.0) return v / norm;
    }
  }

 private:
  std::uint64_t seed_, counter_ = 0;
};

inline constexpr PairKind kBoundedKinds[] = {PairKind::point_point, PairKind::point_edge,
                                             PairKind::point_triangle, PairKind::edge_edge};

// A pair of any shape: generic, on a coarse lattice (where touching, coincident projections,
// parallel edges, zero lengths and zero areas abound), with points drawn onto lines and planes of
// others, near parallel, thin, small against their distance from the origin.
inline PairPositions sample_pair(Stream& random) {
  PairPositions p;
  const int form = random.integer(6);
  for (Vec3& x : p) x = random.vector();
  if (form == 1) {
    for (Vec3& x : p) x = (2.0 * x).array().round().matrix();
  } else if (form == 2) {  // edges nearly parallel, apart by any distance
    const Vec3 along = p[1] - p[0];
    p[2] = p[0] + random.uniform(-1.0, 1.0) * along + random.scale(1e-9, 1.0) * random.direction();
    p[3] = p[2] + random.uniform(-1.5, 1.5) * along + random.scale(1e-14, 0.1) * random.direction();
  } else if (form == 3) {  // a thin triangle, or edges at a point
    p[3] = p[1] + random.uniform(-0.5, 1.5) * (p[2] - p[1]) +
           random.scale(1e-13, 0.1) * random.direction();
  } else if (form == 4) {  // a point over a feature of the others
    const double s = random.integer(3) * 0.5, t = random.integer(3) * 0.5;
    p[0] = p[1] + s * (p[2] - p[1]) + t * (p[3] - p[1]) +
           random.scale(1e-12, 1.0) * random.direction();
  } else if (form == 5) {  // far from the origin
    const Vec3 shift = random.vector(100.0);
    for (Vec3& x : p) x = shift + random.scale(1e-3, 1.0) * x;
  }
  return p;
}

}  // namespace retiarius::testing

// The explicit scheme as one would write it first: one loop over springs, one over nodes.
#pragma once

#include <vector>

#include "retiarius/net/network.hpp"

namespace retiarius::benchmarks {

// Semi-implicit Euler on point masses joined by damped springs, tension-only where the material is;
// no bending. Scalar and unordered on purpose: it is the opponent of the sweeps in vectors. With
// the same step it is as accurate as these but for the first-order damping.
class PlainExplicit {
 public:
  explicit PlainExplicit(const Network& network);

  // The step at which straight taut threads are stable, s: h^2 sum k + 2 h sum k tau = 2 m at the
  // worst node, since here the damping is that of the present velocities.
  double stable_step() const;

  void step(double h);

  std::vector<Vec3> x, v;  // m, m/s

 private:
  struct Spring {
    Index a, b;
    double rest, stiffness, damping;  // m, N/m, s
    bool compression;
  };
  std::vector<Spring> springs_;
  std::vector<double> mass_;
  std::vector<Vec3> force_;
};

}  // namespace retiarius::benchmarks

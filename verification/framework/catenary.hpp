// Hanging lines without bending, in closed form.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace retiarius::verification {

// The inextensible line of length 1 and weight 1 between ends of one height, `span` < 1 apart.
struct Catenary {
  double sag = 0.0;      // below the ends
  double pull = 0.0;     // horizontal force
  double tension = 0.0;  // at the ends
};
Catenary catenary(double span);

// An elastic line (Irvine, Cable Structures, 1981): length unstretched (m), weight per unstretched
// length (N/m), EA (N).
struct ElasticCable {
  double length = 0.0, weight = 0.0, stiffness = 0.0;

  // From the first end in the origin, which is pulled by the support with (-pull, lift) (N), to the
  // point of unstretched arc length s: x to the right, y up.
  Eigen::Vector2d point(double pull, double lift, double s) const;
  Eigen::Vector2d end(double pull, double lift) const { return point(pull, lift, length); }
};

// The support's (pull, lift) at the first end for which the far end is at (x, y).
Eigen::Vector2d end_forces(const ElasticCable& cable, const Eigen::Vector2d& far);

// The same where a load (N) hangs from the line at arc length s.
Eigen::Vector2d end_forces(const ElasticCable& cable, const Eigen::Vector2d& far, double load,
                           double s);

// The problem of n equal segments with half the weight of each on its nodes: length 1, weight 1,
// ends of one height a span apart, inextensible. Positions of the nodes and horizontal force.
struct Chain {
  double pull = 0.0;
  std::vector<Eigen::Vector2d> nodes;
};
Chain chain(int segments, double span);

}  // namespace retiarius::verification

// The size of a stowed net.
#pragma once

#include <vector>

#include "retiarius/net/network.hpp"

namespace retiarius {

// The smallest circle that holds all points of a plane.
struct Circle {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radius = 0.0;
};
// Welzl's algorithm (1991), iterative, on the points in a fixed shuffled order; expected linear
// time. No points: radius 0.
Circle smallest_circle(std::vector<Eigen::Vector2d> points);

// The smallest cylinder along an axis that holds all threads (centre lines and their radii).
struct Bundle {
  double diameter = 0.0;       // m
  double height = 0.0;         // m
  double packing_ratio = 0.0;  // volume of thread over volume of the cylinder
};
Bundle measure_bundle(const Network& network, const std::vector<Vec3>& x, const Vec3& axis);

}  // namespace retiarius

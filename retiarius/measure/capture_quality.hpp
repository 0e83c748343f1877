// How closely a net wraps a target: the capture quality index, and when it has come to rest.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "retiarius/base/archive.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/measure/hull.hpp"

namespace retiarius {

// What the index compares with, the same at any time.
struct QualityScale {
  double volume = 0.0;  // of the target's convex hull, m3
  double area = 0.0;    // of its surface, m2
  double length = 0.0;  // diameter of the smallest sphere about the mass centre that holds it, m
};

// Of a body; absent for a plane. Exact for the convex shapes, for a mesh by its convex hull.
std::optional<QualityScale> quality_scale(const Body& target);

// Capture quality index (Barnes & Botta, "A quality index for net-based capture of space debris",
// Acta Astronautica 176, 2020):
//   0.1 |V_n - V_t| / V_t + 0.1 |S_n - S_t| / S_t + 0.8 |q| / L_c
// with volume V and surface S of the convex hulls of net (its nodes) and target, and q from the
// target's mass centre to that of the net. 0 is a net that is the target's hull; smaller is better.
// Where the nodes lie in a plane (no hull), V_n = 0 and S_n counts both faces of their flat hull.
// nodes: m; mass: of each node, kg; `hull` is that of the nodes.
double capture_quality(const QualityScale& target, const Vec3& target_center,
                       const std::vector<Vec3>& nodes, const std::vector<double>& mass,
                       const std::optional<ConvexHull>& hull);

// Area of the convex hull of points that lie in a plane, one face, m2; 0 for points on a line.
double flat_hull_area(const std::vector<Vec3>& points);

// Whether a value that is seen again and again has come to rest: the settled value is its mean
// over the last 0.5 s, and it has settled if it stayed within 5 % of that for all of them. The
// settling time is the first time from which on it stayed so to the end.
class Settling {
 public:
  // Times ascend; a time seen again replaces its value.
  void see(double time, double value);
  std::optional<double> value() const;
  std::optional<double> time() const;

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive);

 private:
  std::optional<std::pair<double, std::size_t>> settled() const;  // value, first sample within

  std::vector<std::pair<double, double>> samples_;  // time, value
};

}  // namespace retiarius

// Small networks made by hand, for the tests of laws, motion and contact.
#pragma once

#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius::testing {

// A thread of given stiffnesses whose mass comes from line_density (kg/m).
inline Material thread_material(double axial_stiffness, double line_density, double radius = 1e-3) {
  Material m;
  m.axial_stiffness = axial_stiffness;
  m.line_density = line_density;
  m.radius = radius;
  return m;
}

inline void add_thread(Network& net, const std::vector<Index>& nodes,
                       const std::vector<double>& rest_lengths, double bending_stiffness) {
  const Index first = net.segment_count();
  const Index thread = static_cast<Index>(net.threads.size());
  net.threads.push_back({nodes, {}, false});
  const double line_density = net.materials[0].line_density;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    net.segments.push_back({nodes[k], nodes[k + 1], rest_lengths[k], 0, thread});
    net.threads.back().segments.push_back(net.segment_count() - 1);
    net.mass[nodes[k]] += 0.5 * line_density * rest_lengths[k];
    net.mass[nodes[k + 1]] += 0.5 * line_density * rest_lengths[k];
  }
  for (std::size_t k = 0; k + 2 < nodes.size(); ++k) {
    const Index s = first + static_cast<Index>(k);
    net.joints.push_back({nodes[k], nodes[k + 1], nodes[k + 2], s, s + 1,
                          0.5 * (rest_lengths[k] + rest_lengths[k + 1]), bending_stiffness});
  }
}

// One thread through the points; rest lengths are the distances between them.
inline Network chain(const std::vector<Vec3>& points, Material material, double extra_mass = 0.0) {
  Network net;
  net.materials = {material};
  net.design = net.initial = points;
  net.velocity.assign(points.size(), Vec3::Zero());
  net.mass.assign(points.size(), extra_mass);
  std::vector<Index> nodes;
  std::vector<double> rest;
  for (std::size_t k = 0; k < points.size(); ++k) {
    nodes.push_back(static_cast<Index>(k));
    if (k > 0) rest.push_back((points[k] - points[k - 1]).norm());
  }
  add_thread(net, nodes, rest, material.bending_stiffness);
  return net;
}

inline Network straight_chain(int segments, double length, Material material,
                              const Vec3& direction = Vec3::UnitX()) {
  std::vector<Vec3> points;
  for (int k = 0; k <= segments; ++k) points.push_back(k * (length / segments) * direction);
  return chain(points, material);
}

inline double total_mass(const Network& net) {
  double sum = 0.0;
  for (double m : net.mass) sum += m;
  return sum;
}

}  // namespace retiarius::testing

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {
namespace {

template <typename... Parts>
[[noreturn]] void refuse(fmt::format_string<Parts...> text, Parts&&... parts) {
  throw Error("network: " + fmt::format(text, std::forward<Parts>(parts)...));
}

void check_nodes(const Network& net) {
  const std::size_t count = net.design.size();
  if (net.initial.size() != count || net.velocity.size() != count || net.mass.size() != count) {
    refuse("{} nodes, but {} initial positions, {} velocities and {} masses", count,
           net.initial.size(), net.velocity.size(), net.mass.size());
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!net.design[i].allFinite() || !net.initial[i].allFinite() || !net.velocity[i].allFinite()) {
      refuse("node {} has a position or velocity that is not finite", i);
    }
    if (!(net.mass[i] > 0.0) || !std::isfinite(net.mass[i])) {
      refuse("node {} has mass {} kg, must be greater than 0", i, net.mass[i]);
    }
  }
}

void check_materials(const Network& net) {
  if (net.materials.empty()) refuse("has no material");
  for (std::size_t i = 0; i < net.materials.size(); ++i) {
    const Material& m = net.materials[i];
    if (!(m.radius > 0.0) || !(m.axial_stiffness > 0.0) || !(m.line_density > 0.0)) {
      refuse("material {} needs radius {} m, EA {} N and line density {} kg/m greater than 0", i,
             m.radius, m.axial_stiffness, m.line_density);
    }
    if (!(m.bending_stiffness >= 0.0) || !(m.damping >= 0.0) || !(m.strength > 0.0)) {
      refuse("material {} has EI {} N m2, damping {} s or strength {} N out of range", i,
             m.bending_stiffness, m.damping, m.strength);
    }
  }
}

bool in_range(Index index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

void check_segments(const Network& net) {
  for (std::size_t i = 0; i < net.segments.size(); ++i) {
    const Segment& s = net.segments[i];
    if (!in_range(s.a, net.design.size()) || !in_range(s.b, net.design.size()) || s.a == s.b) {
      refuse("segment {} joins nodes {} and {}", i, s.a, s.b);
    }
    if (!(s.rest_length > 0.0) || !std::isfinite(s.rest_length)) {
      refuse("segment {} has rest length {} m, must be greater than 0", i, s.rest_length);
    }
    if (!in_range(s.material, net.materials.size())) {
      refuse("segment {} has material {} of {}", i, s.material, net.materials.size());
    }
    if (!in_range(s.thread, net.threads.size())) {
      refuse("segment {} has thread {} of {}", i, s.thread, net.threads.size());
    }
  }
}

bool joins(const Segment& s, Index a, Index b) {
  return (s.a == a && s.b == b) || (s.a == b && s.b == a);
}

void check_joints(const Network& net) {
  for (std::size_t i = 0; i < net.joints.size(); ++i) {
    const Joint& j = net.joints[i];
    const std::size_t count = net.segments.size();
    if (!in_range(j.first, count) || !in_range(j.second, count) || j.first == j.second ||
        !joins(net.segments[j.first], j.a, j.b) || !joins(net.segments[j.second], j.b, j.c)) {
      refuse("joint {} ({}, {}, {}) does not join its segments {} and {}", i, j.a, j.b, j.c,
             j.first, j.second);
    }
    if (!(j.voronoi_length > 0.0) || !(j.bending_stiffness >= 0.0)) {
      refuse("joint {} has length {} m or EI {} N m2 out of range", i, j.voronoi_length,
             j.bending_stiffness);
    }
  }
}

void check_threads(const Network& net) {
  for (std::size_t i = 0; i < net.threads.size(); ++i) {
    const Thread& t = net.threads[i];
    if (t.segments.empty() || t.nodes.size() != t.segments.size() + 1) {
      refuse("thread {} has {} nodes and {} segments", i, t.nodes.size(), t.segments.size());
    }
    for (std::size_t k = 0; k < t.segments.size(); ++k) {
      if (!in_range(t.segments[k], net.segments.size()) ||
          !joins(net.segments[t.segments[k]], t.nodes[k], t.nodes[k + 1]) ||
          net.segments[t.segments[k]].thread != static_cast<Index>(i)) {
        refuse("thread {} does not run along its segment {}", i, t.segments[k]);
      }
    }
  }
}

void check_named(const Network& net, const char* name, const std::vector<Index>& nodes) {
  for (const Index node : nodes) {
    if (!in_range(node, net.design.size())) {
      refuse("{} names node {} of {}", name, node, net.design.size());
    }
  }
}

}  // namespace

void validate(const Network& network) {
  if (network.segments.empty()) refuse("has no segment");
  check_nodes(network);
  check_materials(network);
  check_segments(network);
  check_joints(network);
  check_threads(network);
  check_named(network, "knots", network.knots);
  check_named(network, "corners", network.corners);
  check_named(network, "bullets", network.bullets);
  check_named(network, "perimeter", network.perimeter);
  check_named(network, "center", {network.center});
  if (network.bullets.size() != network.corners.size()) {
    refuse("has {} corners but {} bullets", network.corners.size(), network.bullets.size());
  }
}

}  // namespace retiarius

// Networks of a few nodes, small enough to compute by hand.
#pragma once

#include <utility>
#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/motion/simulation.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {

inline constexpr double kThreadRadius = 0.01;  // m

// Nodes of 1 kg joined by threads of EA = stiffness (N) that are slack up to `slack` times their
// length in `places`.
inline Network make_net(const std::vector<Vec3>& places,
                        const std::vector<std::pair<Index, Index>>& pairs, double stiffness = 100.0,
                        double slack = 1.0) {
  Network net;
  net.design = net.initial = places;
  net.velocity.assign(places.size(), Vec3::Zero());
  net.mass.assign(places.size(), 1.0);
  Material m;
  m.radius = kThreadRadius;
  m.axial_stiffness = stiffness;
  m.compression = false;
  net.materials = {m};
  for (const auto& [a, b] : pairs)
    net.segments.push_back({a, b, slack * (places[b] - places[a]).norm(), 0, kNone});
  net.center = 0;
  return net;
}

// A square of side 2 m in the xy-plane, its corners the mouth.
inline Network make_square(double stiffness = 100.0, double slack = 1.0) {
  Network net = make_net({{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}},
                         {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, stiffness, slack);
  net.corners = net.perimeter = {0, 1, 2, 3};
  return net;
}

inline Simulation start(const Network& net, const std::vector<Body>& bodies,
                        const EnvironmentSpec& environment = {}, const ContactSpec& contact = {}) {
  Simulation simulation(net, bodies, initial_state(net, bodies));
  simulation.configure(environment, {}, contact);
  return simulation;
}

inline Body make_body(std::shared_ptr<const Shape> shape, ShapeKind kind, const Vec3& position) {
  Body body;
  body.name = "target";
  body.shape = std::move(shape);
  body.kind = kind;
  body.fixed = true;
  body.mass = kInfinity;
  body.initial.position = position;
  return body;
}

}  // namespace retiarius

#include "retiarius/measure/clearance.hpp"

#include <random>

#include <gtest/gtest.h>

#include "retiarius/bodies/free_rotation.hpp"
#include "retiarius/bodies/primitives.hpp"
#include "tiny_nets.hpp"

namespace retiarius {
namespace {

// Asks every node and segment of every body.
double everywhere(const Network& net, const std::vector<Body>& bodies, const State& s) {
  double best = kInfinity;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const Segment& e : net.segments) {
      const Vec3 p = to_body(s.bodies[b], s.x[e.a]), q = to_body(s.bodies[b], s.x[e.b]);
      const double r = net.materials[e.material].radius;
      best = std::min({best, bodies[b].shape->nearest(p).distance - r,
                       bodies[b].shape->nearest(q).distance - r,
                       bodies[b].shape->segment_distance(p, q) - r});
    }
  }
  return best;
}

// A chain that wanders about, of two thicknesses.
Network chain(int nodes, std::mt19937& engine) {
  std::normal_distribution<double> normal(0.0, 0.5);
  std::vector<Vec3> places = {Vec3(2, 0, 0)};
  std::vector<std::pair<Index, Index>> pairs;
  for (int k = 1; k < nodes; ++k) {
    places.push_back(0.97 * places.back() + Vec3(normal(engine), normal(engine), normal(engine)));
    pairs.emplace_back(k - 1, k);
  }
  Network net = make_net(places, pairs);
  net.materials.push_back(net.materials[0]);
  net.materials[1].radius = 0.1;
  for (std::size_t k = 0; k < net.segments.size(); k += 3) net.segments[k].material = 1;
  return net;
}

TEST(Clearance, IsAbsentWithoutBodies) {
  const Network net = make_square();
  const std::vector<Body> none;
  EXPECT_FALSE(Clearance(net, none).measure(initial_state(net, none)).has_value());
}

TEST(Clearance, OfASegmentBesideASphere) {
  const Network net = make_net({{-2, 0, 3}, {2, 0, 3}}, {{0, 1}});
  const std::vector<Body> bodies = {
      make_body(make_sphere(1.0), ShapeKind::sphere, Vec3(0.3, 0, 0))};
  Clearance clearance(net, bodies);
  EXPECT_NEAR(*clearance.measure(initial_state(net, bodies)), 2.0 - kThreadRadius, 1e-14);
}

TEST(Clearance, IsNegativeWhereASegmentCutsTheBodyBetweenItsNodes) {
  const Network net = make_net({{-2, 0, 0.9}, {2, 0, 0.9}}, {{0, 1}});
  const std::vector<Body> bodies = {make_body(make_sphere(1.0), ShapeKind::sphere, Vec3::Zero())};
  Clearance clearance(net, bodies);
  EXPECT_NEAR(*clearance.measure(initial_state(net, bodies)), -0.1 - kThreadRadius, 1e-14);
}

// Net and turning bodies move about: what is remembered never hides the nearest place.
TEST(Clearance, AgreesWithAskingEverywhere) {
  std::mt19937 engine(11);
  std::normal_distribution<double> normal;
  const Network net = chain(60, engine);
  const std::vector<std::vector<Body>> worlds = {
      {make_body(make_sphere(0.7), ShapeKind::sphere, Vec3(1, 1, 0))},
      {make_body(make_box(Vec3(1, 2, 0.2)), ShapeKind::box, Vec3(6, 0, 0)),
       make_body(make_cylinder(0.3, 2.0), ShapeKind::cylinder, Vec3(0, 5, 0)),
       make_body(make_plane(), ShapeKind::plane, Vec3(0, 0, -8))},
      {make_body(make_cone(1.0, 1.5), ShapeKind::cone, Vec3(-30, 0, 0)),
       make_body(make_capsule(0.2, 1.0), ShapeKind::capsule, Vec3(0, 0, 2))}};
  for (const std::vector<Body>& bodies : worlds) {
    Clearance clearance(net, bodies);
    State s = initial_state(net, bodies);
    for (int step = 0; step < 60; ++step) {
      const double size = step % 10 == 9 ? 1.0 : 0.02;  // now and then it jumps
      for (Vec3& x : s.x) x += size * Vec3(normal(engine), normal(engine), normal(engine));
      for (BodyState& b : s.bodies) {
        b.position += 0.05 * Vec3(normal(engine), normal(engine), normal(engine));
        b.attitude = rotation(size * Vec3(normal(engine), 0.3, normal(engine))) * b.attitude;
      }
      ASSERT_NEAR(*clearance.measure(s), everywhere(net, bodies, s), 1e-11) << "step " << step;
    }
  }
}

TEST(Clearance, AsksLittleOnceItKnowsTheWay) {
  std::mt19937 engine(3);
  const Network net = chain(2000, engine);
  const std::vector<Body> bodies = {
      make_body(make_box(Vec3(1, 1, 1)), ShapeKind::box, Vec3(40, 0, 0))};
  Clearance clearance(net, bodies);
  State s = initial_state(net, bodies);
  clearance.measure(s);
  for (int step = 0; step < 20; ++step) {
    for (Vec3& x : s.x) x.x() += 0.1;
    ASSERT_NEAR(*clearance.measure(s), everywhere(net, bodies, s), 1e-11);
    EXPECT_LT(clearance.queries(), 100);
  }
}

}  // namespace
}  // namespace retiarius

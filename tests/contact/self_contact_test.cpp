// Threads on threads: knots stay knots, crossed threads rest on each other, loops stay unlinked.
#include <algorithm>

#include <gtest/gtest.h>

#include "retiarius/contact/distance.hpp"
#include "retiarius/motion/integrator.hpp"
#include "tests/contact/linking.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

IntegratorSpec steps(double h) {
  IntegratorSpec spec = with(Method::implicit_euler);
  spec.step = h;
  spec.max_iterations = 200;
  return spec;
}

ContactSpec threads(double gap, double friction = 0.0) {
  ContactSpec spec = barriers(friction);
  spec.self = true;
  spec.thread_friction = friction;
  spec.gap = gap;
  return spec;
}

// The smallest distance of two segments that share no node and are farther than `apart` from each
// other along the thread: by walking over all pairs.
double closest(const Network& net, const std::vector<Vec3>& x, std::size_t apart = 1) {
  double least = kInfinity;
  for (std::size_t i = 0; i < net.segments.size(); ++i) {
    for (std::size_t j = i + 1; j < net.segments.size(); ++j) {
      const Segment &s = net.segments[i], &t = net.segments[j];
      if (s.thread == t.thread && j - i <= apart) continue;
      if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) continue;
      least =
          std::min(least, distance(PairKind::edge_edge, {x[s.a], x[s.b], x[t.a], x[t.b]}).value);
    }
  }
  return least;
}

// A long trefoil (Shastri 1992: t^3 - 3t, t^4 - 4t^2, t^5 - 10t), flattened, in pieces of one
// length, with straight ends.
std::vector<Vec3> overhand(double size, double piece, int straight) {
  const auto curve = [size](double t) -> Vec3 {
    const double t2 = t * t;
    return size * Vec3(t * (t2 - 3.0), t2 * (t2 - 4.0), 0.2 * t * (t2 * t2 - 10.0));
  };
  std::vector<Vec3> points{curve(-2.1)};
  double way = 0.0;
  Vec3 before = points.back();
  for (double t = -2.1; t < 2.1; t += 1e-4) {
    const Vec3 p = curve(t);
    way += (p - before).norm();
    before = p;
    if (way < piece) continue;
    points.push_back(p);
    way = 0.0;
  }
  std::vector<Vec3> all;
  const auto lead = [&](const Vec3& from, const Vec3& along) {
    std::vector<Vec3> result;
    for (int k = 1; k <= straight; ++k) result.push_back(from + k * piece * along);
    return result;
  };
  std::vector<Vec3> begin = lead(points.front(), (points[0] - points[1]).normalized());
  std::vector<Vec3> end =
      lead(points.back(), (points.back() - points[points.size() - 2]).normalized());
  all.assign(begin.rbegin(), begin.rend());
  all.insert(all.end(), points.begin(), points.end());
  all.insert(all.end(), end.begin(), end.end());
  return all;
}

// Its ends joined far away on either side, for the knot's invariant.
double knot(std::vector<Vec3> x) {
  const Vec3 axis = (x.back() - x.front()).normalized();
  const Vec3 side = axis.unitOrthogonal();
  x.push_back(x.back() + 10.0 * axis);
  x.push_back(x.back() + 30.0 * side);
  const Vec3 start = x.front() - 10.0 * axis;
  x.push_back(start + 30.0 * side);
  x.push_back(start);
  return knot_determinant(x);
}

TEST(KnotDeterminant, TellsKnots) {
  std::vector<Vec3> ring, trefoil, eight;
  for (int k = 0; k < 60; ++k) {
    const double t = 2.0 * kPi * k / 60.0;
    ring.push_back({std::cos(t), std::sin(t), 0.3 * std::sin(2 * t)});
    trefoil.push_back({std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
                       -std::sin(3.0 * t)});
    const double r = 2.0 + std::cos(2.0 * t);
    eight.push_back({r * std::cos(3.0 * t), r * std::sin(3.0 * t), std::sin(4.0 * t)});
  }
  EXPECT_NEAR(knot_determinant(ring), 1.0, 1e-9);
  EXPECT_NEAR(knot_determinant(trefoil), 3.0, 1e-9);
  EXPECT_NEAR(knot_determinant(eight), 5.0, 1e-9);
}

TEST(LinkingNumber, CountsHowRingsAreLinked) {
  std::vector<Vec3> a, b, c;
  for (int k = 0; k < 40; ++k) {
    const double t = 2.0 * kPi * k / 40.0;
    a.push_back({std::cos(t), std::sin(t), 0.0});
    b.push_back({1.0 + std::cos(t), 0.0, std::sin(t)});
    c.push_back({3.5 + std::cos(t), 0.0, std::sin(t)});
  }
  EXPECT_NEAR(std::abs(linking_number(a, b)), 1.0, 1e-12);
  EXPECT_NEAR(linking_number(a, c), 0.0, 1e-12);
}

// An overhand knot pulled by both ends: it closes up, jams, and stays a knot.
TEST(Knot, AnOverhandKnotPulledTightStaysAKnot) {
  const double radius = 2e-3, piece = 5e-3;
  Material m = thread_material(2e3, 1e-2, radius);
  m.bending = Bending::bounded;
  m.bending_stiffness = 1e-5;
  m.damping = 1e-3;
  const std::vector<Vec3> points = overhand(0.016, piece, 8);
  ASSERT_NEAR(knot(points), 3.0, 1e-6);
  const Network net = chain(points, m);
  ASSERT_GT(closest(net, points, 3), 2.0 * radius);
  double length = 0.0;
  for (const Segment& s : net.segments) length += s.rest_length;
  const std::vector<Body> none;
  Simulation sim(net, none, initial_state(net, none));
  const double h = 5e-3, gap = 5e-4;
  sim.configure({{0, 0, 0}, 2.0}, steps(h), threads(gap, 0.2));
  const auto last = static_cast<Index>(points.size() - 1);
  const Vec3 axis = (points.back() - points.front()).normalized();
  double force = 0.0, least = kInfinity;
  // Both ends are drawn apart at 0.1 m/s each until they pull with 20 N.
  const double speed = 0.1;
  for (int k = 1; k <= 600 && force < 20.0; ++k) {
    const double end = k * h;
    const auto drag = [&](double t) {
      return std::vector<Prescribed>{{0, points.front() - speed * t * axis, -speed * axis},
                                     {last, points.back() + speed * t * axis, speed * axis}};
    };
    while (sim.state().time < end) sim.advance(end, drag);
    least = std::min(least, closest(net, sim.state().x, 3));
    force = sim.tensions().front();
  }
  const std::vector<Vec3>& x = sim.state().x;
  EXPECT_GE(force, 20.0);
  EXPECT_NEAR(knot(x), 3.0, 1e-6);
  const double span = (x.back() - x.front()).norm();
  // The tightest open trefoil takes up 10.1 thicknesses of a rope (Pieranski et al., "Tight open
  // knots", Eur. Phys. J. E 6 (2001)); a stiff one of few pieces somewhat more.
  EXPECT_GT((length - span) / (2.0 * radius), 10.1);
  EXPECT_LT((length - span) / (2.0 * radius), 14.0);
  EXPECT_GT(least, 2.0 * radius);
  ::testing::Test::RecordProperty("taken_up_over_thickness",
                                  std::to_string((length - span) / (2.0 * radius)));
  ::testing::Test::RecordProperty("closest_over_thickness", std::to_string(least / (2.0 * radius)));
}

// Several threads at once: chains of one material.
Network chains(const std::vector<std::vector<Vec3>>& all, const Material& material) {
  Network net;
  net.materials = {material};
  for (const std::vector<Vec3>& points : all) {
    std::vector<Index> nodes;
    std::vector<double> rest;
    for (std::size_t k = 0; k < points.size(); ++k) {
      nodes.push_back(net.node_count());
      net.design.push_back(points[k]);
      net.mass.push_back(0.0);
      if (k > 0) rest.push_back((points[k] - points[k - 1]).norm());
    }
    add_thread(net, nodes, rest, material.bending_stiffness);
  }
  net.initial = net.design;
  net.velocity.assign(net.design.size(), Vec3::Zero());
  return net;
}

std::vector<Vec3> line(const Vec3& from, const Vec3& to, int pieces) {
  std::vector<Vec3> points;
  for (int k = 0; k <= pieces; ++k) points.push_back(from + (to - from) * k / pieces);
  return points;
}

Material soft_thread(double radius) {
  Material m = thread_material(1e3, 1e-2, radius);
  m.bending = Bending::bounded;
  m.bending_stiffness = 2e-5;
  m.damping = 1e-3;
  return m;
}

// A thread dropped across another that is held at its ends hangs over it, carried by it.
TEST(Crossing, AThreadDroppedOnAnotherRestsOnIt) {
  const double radius = 1e-3, gap = 2e-4, g = 9.81;
  const Network net =
      chains({line({-0.1, 0, 0}, {0.1, 0, 0}, 9), line({0, -0.06, 0.02}, {0, 0.06, 0.02}, 9)},
             soft_thread(radius));
  const std::vector<Body> none;
  Simulation sim(net, none, initial_state(net, none));
  sim.configure({{0, 0, -g}, 4.0}, steps(4e-3), threads(gap, 0.3));
  run(sim, 4e-3, 800, hold(net.initial, {0, 9}));
  const double least = closest(net, sim.state().x, 3);
  EXPECT_GT(least, 2.0 * radius);
  EXPECT_LT(least, 2.0 * radius + gap);
  double weight = 0.0;
  for (std::size_t i = 10; i < net.mass.size(); ++i) weight += net.mass[i] * g;
  Vec3 up = Vec3::Zero(), down = Vec3::Zero();
  for (const PairContact& c : sim.contacts())
    for (int i = 0; i < 4; ++i) (c.places[i].point >= 10 ? up : down) += c.point_force[i];
  EXPECT_NEAR(up.z(), weight, 1e-4 * weight);
  EXPECT_LT((up + down).norm(), 1e-12 * weight);
  ::testing::Test::RecordProperty("gap_over_range", std::to_string((least - 2.0 * radius) / gap));
}

// A cup of fixed boxes, 60 mm wide inside and 120 mm deep.
std::vector<Body> cup() {
  const double in = 0.03, wall = 0.01, deep = 0.12;
  std::vector<Body> bodies{
      box({2 * (in + wall), 2 * (in + wall), wall}, 0, {0, 0, -0.5 * wall}, BodyMotion::fixed)};
  for (const double side : {-1.0, 1.0}) {
    const double at = side * (in + 0.5 * wall);
    bodies.push_back(box({wall, 2 * (in + wall), deep}, 0, {at, 0, 0.5 * deep}, BodyMotion::fixed));
    bodies.push_back(box({2 * in, wall, deep}, 0, {0, at, 0.5 * deep}, BodyMotion::fixed));
  }
  return bodies;
}

// Layers of five threads, every other across, fall into a cup on one another.
void drop_into_cup(int layers, double time) {
  const double radius = 1e-3, gap = 2.5e-4, h = 5e-3;
  std::vector<std::vector<Vec3>> all;
  for (int layer = 0; layer < layers; ++layer) {
    for (int k = 0; k < 5; ++k) {
      const double off = -0.02 + 0.01 * k, tilt = 2e-3 * std::sin(3.0 * k + 2.0 * layer);
      const double z = 0.01 + 5e-3 * layer;
      const Vec3 from(-0.025, off - tilt, z), to(0.025, off + tilt, z);
      all.push_back(layer % 2 ? line({from.y(), from.x(), z}, {to.y(), to.x(), z}, 4)
                              : line(from, to, 4));
    }
  }
  const Network net = chains(all, soft_thread(radius));
  const std::vector<Body> bodies = cup();
  Simulation sim(net, bodies, initial_state(net, bodies));
  sim.configure({{0, 0, -9.81}, 4.0}, steps(h), threads(gap, 0.3));
  double least = kInfinity;
  run(sim, h, static_cast<int>(std::lround(time / h)), {},
      [&](int) { least = std::min(least, closest(net, sim.state().x, 2)); });
  EXPECT_GT(least, 2.0 * radius);
  double highest = 0.0, fastest = 0.0;
  for (std::size_t i = 0; i < net.mass.size(); ++i) {
    const Vec3& x = sim.state().x[i];
    EXPECT_GT(x.z(), radius) << i;
    EXPECT_LT(std::max(std::abs(x.x()), std::abs(x.y())), 0.03 - radius) << i;
    highest = std::max(highest, x.z());
    fastest = std::max(fastest, sim.state().v[i].norm());
  }
  // They have fallen, lie on one another, and rest but for some that still sag.
  EXPECT_LT(highest, 0.01 + 4e-3 * layers);
  EXPECT_GT(highest, 1.2e-3 * layers);
  EXPECT_LT(fastest, 0.1);
  ::testing::Test::RecordProperty("closest_over_thickness", std::to_string(least / (2.0 * radius)));
  ::testing::Test::RecordProperty("contacts", static_cast<int>(sim.contacts().size()));
}

TEST(Bundle, AHundredThreadsDroppedIntoACupLieOnOneAnother) { drop_into_cup(20, 0.5); }

}  // namespace
}  // namespace retiarius

// Barrier contact against what statics and a point mass's mechanics say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr double kG = 9.81;  // m/s2
const Vec3 kGravity(0, 0, -kG);

IntegratorSpec steps(double h, Method method = Method::implicit_euler) {
  IntegratorSpec spec = with(method);
  spec.step = h;
  return spec;
}

ContactSpec near(double gap, double friction = 0.0) {
  ContactSpec spec = barriers(friction);
  spec.gap = gap;
  return spec;
}

// A square net lying on a ball, brought to rest by damping: the ball carries its weight.
TEST(BarrierRest, ABallCarriesTheNetsWeight) {
  NetSpec spec;
  spec.pattern = Pattern::square;
  spec.side = 0.6;
  spec.mesh = 0.1;
  spec.segments = 2;
  spec.thread.young_modulus = 1e6;
  spec.thread.density = 1000.0;
  spec.thread.radius = 0.004;
  spec.position = {0, 0, 0.206};
  const Network net = build_network(spec);
  const std::vector<Body> bodies{sphere(0.2, 0, {0, 0, 0}, BodyMotion::fixed)};
  Simulation sim(net, bodies, initial_state(net, bodies));
  sim.configure({kGravity, 8.0}, steps(0.01), barriers(0.3));
  run(sim, 0.01, 400);
  Vec3 force = Vec3::Zero(), touches = Vec3::Zero();
  for (const PairContact& c : sim.contacts())
    for (int i = 0; i < point_count(c.pair.kind); ++i)
      if (c.places[i].owner == kNet) force += c.point_force[i];
  for (const Touch& t : sim.state().touches) touches += t.reaction;
  const double weight = total_mass(net) * kG;
  EXPECT_NEAR(force.z(), weight, 1e-5 * weight);
  EXPECT_LT(force.head<2>().norm(), 1e-5 * weight);
  EXPECT_LT((force - touches).norm(), 1e-12 * weight);
  RecordProperty("error_of_weight", fmt::format("{:.3g}", force.z() / weight - 1.0));
  for (std::size_t i = 0; i < sim.state().x.size(); ++i)
    EXPECT_GT(sim.state().x[i].norm(), 0.204) << i;
}

// What a phase spent on looking for contacts is not lost when the next one sets up its own.
TEST(BarrierTimes, CountFromTheStartThroughPhases) {
  const Network net = two_masses({0, 0, 2.5e-3});
  const std::vector<Body> bodies{fixed_plane()};
  Simulation sim(net, bodies, initial_state(net, bodies));
  double before = 0.0;
  for (int phase = 0; phase < 3; ++phase) {
    sim.configure({kGravity, 0.0}, steps(0.01), barriers());
    EXPECT_EQ(sim.work_times().search, before);
    run(sim, 0.01, 20);
    EXPECT_GT(sim.work_times().search, before);
    EXPECT_LE(sim.work_times().search, sim.work_times().contact);
    before = sim.work_times().search;
  }
}

// A thread half round a fixed drum, 1 kg on its light end, dragged over it steadily at `speed` by
// its other end.
double tension_ratio(double friction, int wrap) {
  const double radius = 1e-3, drum = 0.1, r = 1.005 * drum + radius, piece = r * kPi / wrap;
  BodySpec spec;
  spec.shape = ShapeKind::cylinder;
  spec.radius = drum;
  spec.length = 0.2;
  spec.motion = BodyMotion::fixed;
  spec.attitude_deg = {90, 0, 0};  // axis along y
  const std::vector<Body> bodies{build_body(spec, "")};
  std::vector<Vec3> points;
  const int leg = wrap;
  for (int k = leg; k > 0; --k) points.push_back({-r, 0, -k * piece});
  for (int k = 0; k <= wrap; ++k)
    points.push_back({-r * std::cos(kPi * k / wrap), 0, r * std::sin(kPi * k / wrap)});
  for (int k = 1; k <= leg; ++k) points.push_back({r, 0, -k * piece});
  // Heavy enough for a definite matrix, light against the tensions of 10 N and more.
  Material m = thread_material(2e4, 1e-4, radius);
  m.compression = false;
  m.damping = 1e-3;
  Network net = chain(points, m);
  net.mass.front() += 1.0;
  Simulation sim(net, bodies, initial_state(net, bodies));
  const double h = 1e-3, speed = 0.1;
  sim.configure({kGravity, 0.0}, steps(h), near(1e-4, friction));
  const auto last = static_cast<Index>(points.size() - 1);
  const auto drag = [&](double t) {
    // Begins gently, so that the weight does not swing: speed (1 - cos) / 2 over 0.1 s.
    const double rise = std::min(t / 0.1, 1.0);
    const double way =
        rise < 1.0 ? 0.5 * speed * (t - 0.1 / kPi * std::sin(kPi * rise)) : speed * (t - 0.05);
    const double now = rise < 1.0 ? 0.5 * speed * (1.0 - std::cos(kPi * rise)) : speed;
    return std::vector<Prescribed>{{last, points.back() - Vec3(0, 0, way), Vec3(0, 0, -now)}};
  };
  double light = 0.0, heavy = 0.0;
  run(sim, h, 500, drag, [&](int k) {
    if (k <= 300) return;
    light += sim.tensions().front();
    heavy += sim.tensions().back();
  });
  return heavy / light;
}

TEST(BarrierCapstan, TensionsObeyEulerAndEytelwein) {
  for (double friction : {0.1, 0.2, 0.3, 0.5}) {
    const double exact = std::exp(friction * kPi), ratio = tension_ratio(friction, 36);
    EXPECT_NEAR(ratio, exact, 0.01 * exact) << friction;
    RecordProperty("error_at_" + std::to_string(friction), std::to_string(ratio / exact - 1.0));
  }
}

// Displacement down a plane of 30 degrees, from rest, between two times.
double incline_way(double friction, double h, double from, double to) {
  const std::vector<Body> bodies{fixed_plane({0, 30, 0})};  // falls towards +x
  const Vec3 normal = bodies[0].initial.attitude * Vec3::UnitZ();
  const Network net = two_masses((kRadius + 1.9e-4) * normal);
  Simulation sim(net, bodies, initial_state(net, bodies));
  ContactSpec contact = near(2e-4, friction);
  contact.stick_speed = 1e-4;
  contact.friction_tolerance = 1e-6;
  contact.friction_rounds = 100;
  sim.configure({kGravity, 0.0}, steps(h), contact);
  Vec3 start = net.initial[0];
  run(sim, h, static_cast<int>(std::lround(to / h)), {}, [&](int k) {
    if (k * h <= from + 1e-9) start = sim.state().x[0];
  });
  const Vec3 moved = sim.state().x[0] - start;
  EXPECT_NEAR(moved.y(), 0.0, 1e-9);
  return (moved - normal * normal.dot(moved)).norm();
}

TEST(BarrierIncline, SticksJustBelowTheAngleOfFriction) {
  // It creeps below stick_speed, at which friction is full: 0.86 of it at 1 / 1.02 of full.
  const double way = incline_way(1.02 * std::tan(radians(30.0)), 0.01, 0.1, 1.1);
  EXPECT_NEAR(way, (1.0 - std::sqrt(1.0 - 1.0 / 1.02)) * 1e-4, 2e-6);
}

TEST(BarrierIncline, SlipsJustAboveTheAngleOfFriction) {
  const double slope = radians(30.0);
  for (double share : {0.98, 0.5}) {
    const double mu = share * std::tan(slope), t = 1.0;
    const double a = kG * (std::sin(slope) - mu * std::cos(slope));
    const double exact = 0.5 * a * t * t, way = incline_way(mu, 1e-3, 0.0, t);
    EXPECT_NEAR(way, exact, 0.02 * exact) << share;
    RecordProperty(fmt::format("slip_{}", share), fmt::format("{:.3g}", way / exact - 1.0));
  }
}

TEST(BarrierSlide, LeavesASmoothSphereAtCosTwoThirds) {
  const double start = 0.1, r = 1.0 + kRadius + 1.99e-4;
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint}) {
    const std::vector<Body> bodies{sphere(1.0, 0, {0, 0, 0}, BodyMotion::fixed)};
    Network net = two_masses({r * std::sin(start), 0, r * std::cos(start)});
    for (int k = 0; k < 2; ++k) net.initial[k].y() *= 1e-6;  // side by side on the meridian
    net.segments[0].rest_length = 1.0;                       // slack
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({kGravity, 0.0}, steps(5e-4, method), near(2e-4));
    // Where nothing damps, the mass trembles in the barrier; it has left where it touches last.
    double left = 0.0;
    for (int k = 1; k <= 4000; ++k) {
      sim.advance(k * 5e-4, {});
      if (!sim.contacts().empty()) left = sim.state().x[0].normalized().z();
    }
    const double exact = 2.0 / 3.0 * std::cos(start);
    EXPECT_NEAR(left, exact, 0.01 * 2.0 / 3.0) << to_string(method);
    RecordProperty(to_string(method), fmt::format("{:.3g}", left / exact - 1.0));
  }
}

// A net that flies against a free body off its centre, and what is kept.
struct Flight {
  double linear = 0.0;   // largest drift over the sum of m |v|
  double angular = 0.0;  // drift at the end, over that of the net's first angular momentum
  double least_loss = kInfinity, loss = 0.0;  // of the integrator, J
  double kinetic = 0.0;                       // at the start, J
  double gain = 0.0;                          // largest rise of the energy, J
  std::size_t contacts = 0;
};

Flight fly(const std::vector<Body>& bodies, const Network& net, double h, double friction,
           double time, Method method = Method::implicit_euler) {
  Simulation sim(net, bodies, initial_state(net, bodies));
  ContactSpec contact = barriers(friction);
  contact.self = true;
  sim.configure({}, steps(h, method), contact);
  Flight f;
  const Vec3 p0 = linear_momentum(sim), l0 = angular_momentum(sim);
  const double p_scale = momentum_scale(sim), e0 = mechanical_energy(sim);
  f.kinetic = e0;
  double before = e0;
  run(sim, h, static_cast<int>(std::lround(time / h)), {}, [&](int) {
    f.linear = std::max(f.linear, (linear_momentum(sim) - p0).norm() / p_scale);
    f.contacts = std::max(f.contacts, sim.contacts().size());
    const double now = mechanical_energy(sim) + sim.contact_energy() + accounted_loss(sim.state());
    f.least_loss = std::min(f.least_loss, before - now);
    f.gain = std::max(f.gain, now - e0);
    before = now;
  });
  f.loss = e0 - before;
  f.angular = (angular_momentum(sim) - l0).norm() / (p_scale * 0.5);
  return f;
}

Network flying_net(bool compression = false) {
  NetSpec spec;
  spec.pattern = Pattern::square;
  spec.side = 1.0;
  spec.mesh = 0.25;
  spec.segments = 2;
  spec.thread.young_modulus = 1e6;
  spec.thread.density = 1000.0;
  spec.thread.radius = 0.005;
  spec.thread.compression = compression;
  spec.position = {0.15, 0.05, 0.35};
  Network net = build_network(spec);
  net.velocity.assign(net.velocity.size(), {0, 0, -2});
  return net;
}

TEST(BarrierMomentum, IsKeptForLightAndHeavyBodies) {
  const Network net = flying_net();
  for (double share : {0.1, 1.0, 10.0, 1e4}) {
    for (double friction : {0.0, 0.3}) {
      const std::vector<Body> bodies{box({0.4, 0.3, 0.2}, share * total_mass(net), {0, 0, 0.1},
                                         BodyMotion::free, {20, 40, -30})};
      const Flight f = fly(bodies, net, 5e-3, friction, 0.4);
      EXPECT_GT(f.contacts, 3u) << share;
      EXPECT_LT(f.linear, 1e-9) << share << " friction " << friction;
      RecordProperty(fmt::format("drift_at_{}_{}", share, friction),
                     fmt::format("{:.3g}", f.linear));
    }
  }
}

TEST(BarrierMomentum, AngularMomentumIsOfTheIntegratorsOrder) {
  const Network net = flying_net();
  const std::vector<Body> bodies{
      box({0.4, 0.3, 0.2}, 10.0, {0, 0, 0.1}, BodyMotion::free, {20, 40, -30})};
  const double coarse = fly(bodies, net, 4e-3, 0.2, 0.2).angular;
  const double fine = fly(bodies, net, 1e-3, 0.2, 0.2).angular;
  EXPECT_LT(fine, 0.5 * coarse) << coarse;
  EXPECT_LT(coarse, 0.02);
  RecordProperty("coarse", fmt::format("{:.3g}", coarse));
  RecordProperty("fine", fmt::format("{:.3g}", fine));
}

// No energy out of nothing: with the barrier's own energy counted, implicit Euler only loses.
TEST(BarrierEnergy, ImplicitEulerOnlyLoses) {
  const Network net = flying_net();
  for (double friction : {0.0, 0.3}) {
    const std::vector<Body> bodies{
        box({0.4, 0.3, 0.2}, 10.0, {0, 0, 0.1}, BodyMotion::free, {20, 40, -30})};
    const Flight f = fly(bodies, net, 2e-3, friction, 0.4);
    EXPECT_LT(f.gain, 1e-9 * f.kinetic) << friction;
    EXPECT_GT(f.loss, 0.0) << friction;
    EXPECT_GT(f.least_loss, -1e-6 * f.kinetic) << friction;
    RecordProperty(fmt::format("least_loss_{}", friction),
                   fmt::format("{:.3g} of {:.3g}", f.least_loss / f.kinetic, f.loss / f.kinetic));
  }
}

}  // namespace
}  // namespace retiarius

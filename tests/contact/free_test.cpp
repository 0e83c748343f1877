// Contact with free bodies: what a net gives, the body takes.
#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// A soft square net of 1 m flying at 2 m/s towards a body near the origin.
Network soft_net(const Vec3& offset = Vec3::Zero(), const Vec3& velocity = {0, 0, -2}) {
  NetSpec spec;
  spec.pattern = Pattern::square;
  spec.side = 1.0;
  spec.mesh = 0.25;
  spec.segments = 2;
  spec.thread.young_modulus = 1e6;
  spec.thread.density = 1000.0;
  spec.thread.radius = 0.005;
  spec.position = Vec3(0, 0, 0.35) + offset;
  Network net = build_network(spec);
  net.velocity.assign(net.velocity.size(), velocity);
  // Some spin and stretch, so that the flight before contact has both.
  for (std::size_t i = 0; i < net.initial.size(); ++i) {
    const Vec3 r = net.initial[i] - spec.position;
    net.velocity[i] += Vec3(0.1, 0.2, 0.5).cross(r) + 0.2 * Vec3(r.x(), -r.y(), 0.3 * r.x());
  }
  return net;
}

struct Flight {
  double linear_drift = 0.0;    // over sum m |v|
  double angular_before = 0.0;  // over sum m |x - xc| |v - vc| + |I w|, before contact
  double angular_after = 0.0;   // at the end
  double spin_up = 0.0;         // the body's angular momentum about its centre
  int contacts = 0;
  double energy_lost = 0.0, accounted = 0.0;
  double impact_loss = 0.0, friction_loss = 0.0, kinetic = 0.0;
  double first = 0.0;
  double deepest = 0.0;  // m, of a node below its radius
};

Flight fly(const Network& net, const std::vector<Body>& bodies, Method method, double friction,
           double h, double time, double tolerance = 1e-8) {
  Simulation sim(net, bodies, initial_state(net, bodies));
  sim.configure({}, with(method, tolerance), touching(friction));
  const Vec3 p0 = linear_momentum(sim), l0 = angular_momentum(sim);
  const double p_scale = momentum_scale(sim);
  Vec3 center = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < net.mass.size(); ++i) {
    center += net.mass[i] * net.initial[i];
    mass += net.mass[i];
  }
  for (const Body& b : bodies) {
    center += b.mass * b.initial.position;
    mass += b.mass;
  }
  center /= mass;
  double l_scale = 0.0;
  for (std::size_t i = 0; i < net.mass.size(); ++i)
    l_scale +=
        net.mass[i] * (net.initial[i] - center).norm() * (net.velocity[i] - p0 / mass).norm();
  for (const Body& b : bodies) {
    l_scale +=
        b.mass * (b.initial.position - center).norm() * (b.initial.velocity - p0 / mass).norm();
    l_scale += b.initial.angular_momentum.norm();
  }
  Flight f;
  f.kinetic = kinetic_energy(sim);
  const double e0 = mechanical_energy(sim);
  run(sim, h, static_cast<int>(std::lround(time / h)), {}, [&](int) {
    const State& s = sim.state();
    f.linear_drift = std::max(f.linear_drift, (linear_momentum(sim) - p0).norm() / p_scale);
    const double l = (angular_momentum(sim) - l0).norm() / l_scale;
    f.contacts = std::max(f.contacts, static_cast<int>(s.touches.size()));
    if (f.contacts == 0) {
      f.angular_before = std::max(f.angular_before, l);
      f.first = s.time;
    }
    f.angular_after = l;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (const Vec3& x : s.x) {
        const double gap = bodies[b].shape->nearest(to_body(s.bodies[b], x)).distance - 0.005;
        f.deepest = std::max(f.deepest, -gap);
      }
    }
  });
  f.spin_up = sim.state().bodies[0].angular_momentum.norm();
  f.energy_lost = e0 - mechanical_energy(sim);
  f.accounted = accounted_loss(sim.state());
  f.impact_loss = sim.state().account.impact_loss;
  f.friction_loss = sim.state().account.friction_loss;
  return f;
}

// Every push is a pair, so linear momentum holds to the round-off of sums over 81 nodes and
// hundreds of steps, whatever the tolerance of Newton's iteration.
TEST(FreeSphere, LinearMomentumIsKeptByEveryIntegrator) {
  const Network net = soft_net();
  for (Method method : kDynamic) {
    for (double friction : {0.0, 0.3}) {
      const std::vector<Body> bodies{sphere(0.2, 10.0, {0, 0, 0})};
      const Flight f = fly(net, bodies, method, friction, 1e-3, 0.25);
      EXPECT_GT(f.contacts, 3) << to_string(method);
      EXPECT_LT(f.linear_drift, 1e-12) << to_string(method) << " friction " << friction;
      EXPECT_GE(f.impact_loss, 0.0) << to_string(method) << " friction " << friction;
      EXPECT_GE(f.friction_loss, -1e-15) << to_string(method) << " friction " << friction;
      // A node ends each step on the tangent plane of where it was expected: it may sink by a
      // small share of its radius, 5 mm.
      EXPECT_LT(f.deepest, 0.25e-3) << to_string(method) << " friction " << friction;
      // Where nothing else is lost, the account explains the fall of the energy; the integrator's
      // own share is O(h), far smaller with the two of second order.
      if (method != Method::implicit_euler)
        EXPECT_NEAR(f.energy_lost, f.accounted, 2e-3 * f.kinetic) << to_string(method);
      else
        EXPECT_GT(f.energy_lost, f.accounted);
    }
  }
}

TEST(FreeSphere, LinearMomentumIsKeptWithALooseTolerance) {
  const Network net = soft_net({0.1, 0.05, 0});
  const std::vector<Body> bodies{sphere(0.2, 10.0, {0, 0, 0})};
  for (Method method : kDynamic)
    EXPECT_LT(fly(net, bodies, method, 0.3, 1e-3, 0.25, 1e-3).linear_drift, 1e-12)
        << to_string(method);
}

TEST(FreeSphere, MidpointKeepsAngularMomentumBeforeContact) {
  const Network net = soft_net({0.1, 0.05, 0});
  const std::vector<Body> bodies{sphere(0.2, 10.0, {0, 0, 0}, BodyMotion::free, {10, 20, 30})};
  const Flight f = fly(net, bodies, Method::midpoint, 0.0, 1e-3, 0.05, 1e-11);
  EXPECT_EQ(f.contacts, 0);
  EXPECT_LT(f.angular_before, 1e-11);
}

// Bodies from a tenth of the net's mass to ten thousand times it.
TEST(FreeSphere, LightAndHeavyBodies) {
  const Network net = soft_net({0.05, 0, 0});
  for (double share : {0.1, 1.0, 1e4}) {
    const std::vector<Body> bodies{sphere(0.2, share * total_mass(net), {0, 0, 0})};
    for (Method method : kDynamic) {
      const Flight f = fly(net, bodies, method, 0.3, 1e-3, 0.25);
      EXPECT_GT(f.contacts, 1) << to_string(method) << " share " << share;
      EXPECT_LT(f.linear_drift, 1e-12) << to_string(method) << " share " << share;
      EXPECT_LT(f.deepest, 0.5e-3) << to_string(method) << " share " << share;
      EXPECT_GE(f.impact_loss, 0.0);
      EXPECT_GE(f.friction_loss, -1e-15);
    }
  }
}

// An off-centre hit turns a box. Total angular momentum is wrong by O(h) only: it falls at least
// about twofold from h to h/2 (allow 1.5), or is small at once.
TEST(FreeBox, AngularMomentumThroughContactIsOfFirstOrder) {
  const Network net = soft_net({0.3, 0.05, 0});
  for (Method method : kDynamic) {
    const std::vector<Body> bodies{
        box({0.5, 0.3, 0.4}, 10.0, {0, 0, 0}, BodyMotion::free, {20, 40, -30})};
    const Flight coarse = fly(net, bodies, method, 0.3, 2e-3, 0.2);
    const Flight fine = fly(net, bodies, method, 0.3, 0.5e-3, 0.2);
    EXPECT_GT(fine.contacts, 2) << to_string(method);
    EXPECT_GT(fine.spin_up, 0.0);
    EXPECT_LT(fine.angular_after, std::max(2e-4, coarse.angular_after / 2.0)) << to_string(method);
    EXPECT_LT(fine.linear_drift, 1e-12);
  }
}

// A single mass hits a free sphere in its centre: plastic impact, common velocity after it.
TEST(FreeSphere, PlasticImpactGivesTheCommonVelocity) {
  for (double body_mass : {0.05, 1.0, 100.0}) {
    for (Method method : kDynamic) {
      Network net = two_masses({0, 0, 0.2}, {0, 0, -3});
      for (int k = 0; k < 2; ++k) net.initial[k].y() *= 1e-9;
      const std::vector<Body> bodies{sphere(0.1, body_mass, {0, 0, 0})};
      Simulation sim(net, bodies, initial_state(net, bodies));
      sim.configure({}, with(method), touching());
      run(sim, 1e-3, 100);
      // Two nodes of 0.5 kg.
      const double common = -3.0 * 1.0 / (1.0 + body_mass);
      EXPECT_NEAR(sim.state().v[0].z(), common, 1e-6) << to_string(method) << " " << body_mass;
      EXPECT_NEAR(sim.state().bodies[0].velocity.z(), common, 1e-6) << to_string(method);
      const double lost = 0.5 * 9.0 * body_mass / (1.0 + body_mass);
      EXPECT_NEAR(sim.state().account.impact_loss, lost, 1e-5 * lost) << to_string(method);
      EXPECT_LT(std::abs(linear_momentum(sim).z() + 3.0), 1e-12);
    }
  }
}

// Two masses on the face of a body a hundred times lighter than each: what one contact does to the
// other all but undoes it, so that contacts which take turns need many to share one velocity.
TEST(FreeBox, ExplicitContactsOfAVeryLightBodyShareOneVelocity) {
  const double body_mass = 0.005;
  for (double friction : {0.0, 0.3}) {
    const Network net = two_masses({0, 0, 0.2}, {0, 0, -3});
    const std::vector<Body> bodies{box({0.3, 0.3, 0.1}, body_mass, {0, 0, 0})};
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({}, with(Method::explicit_differences), touching(friction));
    run(sim, 1e-3, 100);
    const double common = -3.0 * 1.0 / (1.0 + body_mass);
    const State& s = sim.state();
    EXPECT_NEAR(s.v[0].z(), common, 1e-7) << friction;
    EXPECT_NEAR(s.v[1].z(), common, 1e-7) << friction;
    EXPECT_NEAR(s.bodies[0].velocity.z(), common, 1e-7) << friction;
    EXPECT_LT(s.bodies[0].angular_momentum.norm(), 1e-9) << friction;
    const double lost = 0.5 * 9.0 * body_mass / (1.0 + body_mass);
    EXPECT_NEAR(s.account.impact_loss, lost, 1e-5 * lost) << friction;
    EXPECT_LT(std::abs(linear_momentum(sim).z() + 3.0), 1e-12);
  }
}

}  // namespace
}  // namespace retiarius

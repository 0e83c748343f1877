// Contact with fixed bodies, against what a point mass does.
#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

const Vec3 kGravity(0, 0, -9.81);

// Dropped from 0.05 m: comes to rest (plastic impact) at the thread's radius above the surface,
// which carries its weight. The rest lengths play no part: the thread lies flat or falls level.
TEST(Drop, RestsAtTheThreadsRadiusAndWeighs) {
  const std::vector<std::vector<Body>> grounds = {
      {fixed_plane()}, {box({1, 1, 0.2}, 0, {0, 0, -0.1}, BodyMotion::fixed)}};
  for (const std::vector<Body>& bodies : grounds) {
    for (Method method : kDynamic) {
      const Network net = two_masses({0.1, 0, 0.05});
      Simulation sim(net, bodies, initial_state(net, bodies));
      sim.configure({kGravity, 0.0}, with(method), touching());
      run(sim, 1e-3, 500);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(sim.state().x[i].z(), kRadius, 1e-12) << to_string(method);
        EXPECT_NEAR(sim.state().v[i].norm(), 0.0, 1e-12) << to_string(method);
      }
      ASSERT_EQ(sim.state().touches.size(), 2u) << to_string(method);
      for (const Touch& t : sim.state().touches)
        EXPECT_NEAR((t.reaction + 0.5 * kGravity).norm(), 0.0, 1e-7) << to_string(method);
      // The fall's energy is the impact's loss, but for the fall's last step: m v g h = 0.0095 J.
      EXPECT_NEAR(sim.state().account.impact_loss, 9.81 * (0.05 - kRadius), 0.0095)
          << to_string(method);
      EXPECT_EQ(sim.state().account.friction_loss, 0.0);
    }
  }
}

// On the top of a sphere, held there by the thread's symmetry: two nodes astride the top slide off
// unless tied; with friction 1 they stay where they land.
TEST(Drop, SticksToASphereWithFriction) {
  const std::vector<Body> bodies{sphere(0.5, 0, {0, 0, 0}, BodyMotion::fixed)};
  for (Method method : kDynamic) {
    const Network net = two_masses({0, 0, 0.53});
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({kGravity, 0.0}, with(method), touching(1.0));
    run(sim, 0.005, 100);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(sim.state().x[i].norm(), 0.5 + kRadius, 1e-9) << to_string(method);
      EXPECT_NEAR(sim.state().v[i].norm(), 0.0, 1e-9) << to_string(method);
    }
    Vec3 reaction = Vec3::Zero();
    for (const Touch& t : sim.state().touches) reaction += t.reaction;
    EXPECT_NEAR((reaction + kGravity).norm(), 0.0, 1e-6) << to_string(method);
  }
}

TEST(Drop, IsReleasedWhenPulledAway) {
  const std::vector<Body> bodies{fixed_plane()};
  for (Method method : kDynamic) {
    const Network net = two_masses({0, 0, kRadius});
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({kGravity, 0.0}, with(method), touching(0.5));
    run(sim, 0.01, 10);
    EXPECT_EQ(sim.state().touches.size(), 2u) << to_string(method);
    sim.configure({-kGravity, 0.0}, with(method), touching(0.5));
    const double h = 0.001;
    run(sim, h, 100);
    EXPECT_TRUE(sim.state().touches.empty()) << to_string(method);
    // Free fall upwards from the first step on; Euler's error is g h t / 2.
    const double t = 0.1;
    EXPECT_NEAR(sim.state().x[0].z(), kRadius + 0.5 * 9.81 * t * t, 9.81 * h * t)
        << to_string(method);
  }
}

// A point mass slides off a smooth fixed sphere where cos = 2/3 (energy, and N = 0).
TEST(Slide, LeavesASmoothSphereAtCosTwoThirds) {
  const double r = 1.0 + kRadius;
  for (Method method : kDynamic) {
    const std::vector<Body> bodies{sphere(1.0, 0, {0, 0, 0}, BodyMotion::fixed)};
    const double start = 0.1;  // rad from the top
    Network net = two_masses({r * std::sin(start), 0, r * std::cos(start)});
    for (int k = 0; k < 2; ++k) net.initial[k].y() *= 1e-6;  // side by side on the meridian
    net.segments[0].rest_length = 1.0;                       // slack
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({kGravity, 0.0}, with(method), touching());
    double left = 0.0;
    for (int k = 1; k <= 2000 && left == 0.0; ++k) {
      sim.advance(k * 1e-3, {});
      if (sim.state().touches.empty() && k > 1) left = sim.state().x[0].normalized().z();
    }
    // From rest at cos0: m g cos = m v^2 / r = 2 m g (cos0 - cos).
    EXPECT_NEAR(left, 2.0 / 3.0 * std::cos(start), 0.02 * 2.0 / 3.0) << to_string(method);
  }
}

double incline_displacement(Method method, double slope_deg, double friction, double h, double t) {
  const std::vector<Body> bodies{fixed_plane({0, slope_deg, 0})};  // falls towards +x
  const Vec3 normal = bodies[0].initial.attitude * Vec3::UnitZ();
  const Network net = two_masses(kRadius * normal);
  Simulation sim(net, bodies, initial_state(net, bodies));
  sim.configure({kGravity, 0.0}, with(method), touching(friction));
  run(sim, h, static_cast<int>(std::lround(t / h)));
  const Vec3 moved = sim.state().x[0] - net.initial[0];
  EXPECT_NEAR(moved.dot(normal), 0.0, 1e-9);
  EXPECT_NEAR(moved.y(), 0.0, 1e-9);
  return moved.norm();
}

TEST(Slide, SticksBelowTheAngleOfFrictionAndSlidesAbove) {
  const double slope = 30.0;
  const double tangent = std::tan(radians(slope));
  for (Method method : kDynamic) {
    // Entry is found to a twentieth of the radius along the path: 5e-5 m, half of it downhill.
    EXPECT_LT(incline_displacement(method, slope, 1.02 * tangent, 0.01, 1.0), 2.6e-5)
        << to_string(method);
    EXPECT_GT(incline_displacement(method, slope, 0.98 * tangent, 0.01, 1.0), 0.03)
        << to_string(method);
  }
}

TEST(Slide, AcceleratesByGTimesSineLessFrictionCosine) {
  const double slope = radians(30.0), mu = 0.3, t = 0.5;
  const double a = 9.81 * (std::sin(slope) - mu * std::cos(slope));
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint}) {
    const double h = 1e-3;
    EXPECT_NEAR(incline_displacement(method, 30.0, mu, h, t), 0.5 * a * t * t,
                0.01 * 0.5 * a * t * t)
        << to_string(method);
  }
}

// Friction is less below 1 mm/s, and the start is at rest: less than a tenth of a per cent of the
// way in half a second. The schemes of several weights agree with the midpoint rule on that to a
// third of a per cent.
TEST(Slide, StartsAlikeWithEveryScheme) {
  const double slope = radians(30.0), mu = 0.3, t = 0.5, h = 2.5e-4;
  const double a = 9.81 * (std::sin(slope) - mu * std::cos(slope));
  const double wanted = incline_displacement(Method::midpoint, 30.0, mu, h, t);
  EXPECT_NEAR(wanted / (0.5 * a * t * t), 1.0, 0.001);
  for (Method method : {Method::generalised_alpha, Method::tr_bdf2})
    EXPECT_NEAR(incline_displacement(method, 30.0, mu, h, t), wanted, 0.0033 * wanted)
        << to_string(method);
}

// What slides at the end of a step slides from the start of the next.
TEST(Slide, GoesOnFromStepToStep) {
  for (Method method : kDynamic) {
    const std::vector<Body> bodies{fixed_plane()};
    const Network net = two_masses({0, 0, kRadius}, {1.0, 0, 0});
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({kGravity, 0.0}, with(method), touching(0.2));
    run(sim, 1e-3, 100, {}, [&](int) {
      for (const Touch& t : sim.state().touches) EXPECT_FALSE(t.sticks) << to_string(method);
    });
    EXPECT_EQ(sim.state().touches.size(), 2u) << to_string(method);
  }
}

// A mass thrown along a rough floor stops after v / (mu g), having lost its kinetic energy to
// friction.
TEST(Slide, StopsOnARoughFloorAndTheAccountCloses) {
  const double v = 1.0, mu = 0.4;
  for (Method method : kDynamic) {
    const std::vector<Body> bodies{fixed_plane()};
    const Network net = two_masses({0, 0, kRadius}, {v, 0, 0});
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({kGravity, 0.0}, with(method), touching(mu));
    run(sim, 1e-3, 400);
    EXPECT_NEAR(sim.state().v[0].norm(), 0.0, 1e-9) << to_string(method);
    EXPECT_NEAR(sim.state().x[0].x(), v * v / (2.0 * mu * 9.81), 0.01 * v * v / (2.0 * mu * 9.81))
        << to_string(method);
    EXPECT_NEAR(sim.state().account.friction_loss, 0.5 * v * v, 0.01 * 0.5 * v * v)
        << to_string(method);
    EXPECT_NEAR(sim.state().account.impact_loss, 0.0, 1e-9) << to_string(method);
  }
}

// 20 m/s and h = 0.01 s: 0.2 m a step, forty times the box's thickness.
TEST(FastNode, DoesNotPassThroughAThinBox) {
  const std::vector<Body> bodies{box({1, 1, 0.005}, 0, {0, 0, 0}, BodyMotion::fixed)};
  for (Method method : kDynamic) {
    for (double friction : {0.0, 0.3}) {
      // Starts so that the step ends past the box, in its far half and in its near half.
      for (double height : {0.3, 0.2 + 0.0015, 0.2 - 0.0015, 0.2 + 0.0005, 0.2 - 0.0005}) {
        const Network net = two_masses({0, 0, height}, {1.0, 0, -20.0});
        Simulation sim(net, bodies, initial_state(net, bodies));
        sim.configure({}, with(method), touching(friction));
        run(sim, 0.01, 5);
        EXPECT_NEAR(sim.state().x[0].z(), 0.0025 + kRadius, 1e-6)
            << to_string(method) << " friction " << friction << " from " << height;
      }
    }
  }
}

}  // namespace
}  // namespace retiarius

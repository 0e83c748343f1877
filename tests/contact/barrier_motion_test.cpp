// What barrier contact does over time: fast threads on thin panels, bodies on bodies.
#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/contact/scene.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

IntegratorSpec steps(double h, Method method = Method::implicit_euler) {
  IntegratorSpec spec = with(method);
  spec.step = h;
  return spec;
}

// The smallest distance, over the radius, of threads from a body on the straight ways between
// states, by sampling: every 1e-3 of a step.
class Watch {
 public:
  Watch(const Simulation& sim, double radius)
      : sim_(&sim), radius_(radius), x_(sim.state().x), poses_(sim.state().bodies) {}

  void look() {
    const State& now = sim_->state();
    for (const Segment& s : sim_->network().segments) {
      for (std::size_t b = 0; b < poses_.size(); ++b) {
        for (int k = 0; k <= 1000; ++k) {
          const double distance = at(s, b, 1e-3 * k) / radius_;
          way_ = std::min(way_, distance);
          if (k == 1000) end_ = std::min(end_, distance);
        }
      }
    }
    x_ = now.x;
    poses_ = now.bodies;
  }
  double on_the_way() const { return way_; }
  double at_ends() const { return end_; }

 private:
  double at(const Segment& s, std::size_t b, double t) const {
    const State& now = sim_->state();
    BodyState pose = poses_[b];
    pose.position += t * (now.bodies[b].position - pose.position);
    pose.attitude = pose.attitude.slerp(t, now.bodies[b].attitude);
    const auto node = [&](Index i) { return to_body(pose, x_[i] + t * (now.x[i] - x_[i])); };
    return sim_->bodies()[b].shape->segment_distance(node(s.a), node(s.b));
  }

  const Simulation* sim_;
  double radius_;
  std::vector<Vec3> x_;
  std::vector<BodyState> poses_;
  double way_ = kInfinity, end_ = kInfinity;
};

// A thread 1 mm thick at 20 m/s, 0.2 m a step, 200 times the panel's thickness of 1 mm; from
// places such that a step ends before, in and behind the panel.
void hit_panel(const Vec3& size, BodyMotion motion) {
  const double radius = 5e-4;
  for (double height : {0.31, 0.2 + 0.4 * size.z(), 0.2, 0.05}) {
    Material material = thread_material(5e4, 1.1e-3, radius);
    material.compression = false;
    material.damping = 1e-5;
    std::vector<Vec3> points;
    for (int k = 0; k <= 10; ++k)
      points.push_back({-0.3 + 0.06 * k, 0.013, 0.5 * size.z() + radius + height});
    Network net = chain(points, material);
    net.velocity.assign(points.size(), {0, 0, -20.0});
    const std::vector<Body> bodies{box(size, 0.05, {0, 0, 0}, motion)};
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({}, steps(1e-2), barriers(0.2));
    Watch watch(sim, radius);
    bool touched = false;
    run(sim, 1e-2, 10, {}, [&](int) {
      watch.look();
      touched = touched || !sim.state().touches.empty();
    });
    EXPECT_TRUE(touched) << height;
    EXPECT_GT(watch.at_ends(), 1.0) << height;
    // Half the thickness is promised on the way; the samples lie 2e-4 m apart.
    EXPECT_GT(watch.on_the_way(), 0.5 - 1e-9) << height;
  }
}

TEST(FastThread, DoesNotPassAThinPanelsFace) {
  hit_panel({1, 1, 0.001}, BodyMotion::fixed);
  hit_panel({1, 1, 0.001}, BodyMotion::free);
}

TEST(FastThread, DoesNotPassAThinPanelsEdge) {
  hit_panel({0.001, 1, 0.6}, BodyMotion::fixed);
  hit_panel({0.001, 1, 0.6}, BodyMotion::free);
}

// A net of its own somewhere far away: a simulation has one.
Network far_net() { return two_masses({100, 100, 100}); }

TEST(BodyOnPlane, ABoxDroppedComesToRestAndWeighs) {
  const Network net = far_net();
  const double mass = 3.0, g = 9.81;
  const std::vector<Body> bodies{fixed_plane(), box({0.2, 0.3, 0.1}, mass, {0, 0, 0.08})};
  Simulation sim(net, bodies, initial_state(net, bodies));
  ContactSpec contact = barriers(0.3);
  contact.gap = 1e-3;
  sim.configure({{0, 0, -g}, 0.0}, steps(5e-3), contact);
  run(sim, 5e-3, 199);
  const Vec3 before = sim.state().bodies[1].position;
  run(sim, 5e-3, 1);
  const BodyState& s = sim.state().bodies[1];
  EXPECT_LT((s.position - before).norm(), 1e-10);
  // A body falls exactly, by g h^2 / 2 in a step; the push that undoes this way lacks g h / 2.
  EXPECT_NEAR(s.velocity.z(), -0.5 * g * 5e-3, 1e-6);
  EXPECT_LT(s.angular_momentum.norm(), 1e-7);
  EXPECT_GT(s.position.z(), 0.05);
  EXPECT_LT(s.position.z(), 0.05 + contact.gap);
  Vec3 force = Vec3::Zero();
  for (const PairContact& c : sim.contacts()) force += c.force * c.normal;
  EXPECT_NEAR(force.z(), mass * g, 1e-5 * mass * g);
  EXPECT_LT(force.head<2>().norm(), 1e-8 * mass * g);
}

// An off-centre blow of a turning box on another: momentum, and that nothing passes.
TEST(BodyOnBody, TwoFreeBoxesCollideAndKeepTheirMomentum) {
  const Network net = far_net();
  for (double other : {0.1, 2.0, 1e3}) {
    double drift[2], losses[2];
    for (int k = 0; k < 2; ++k) {
      const double h = 2e-3 / (1 + k);
      std::vector<Body> bodies{
          box({0.2, 0.3, 0.1}, 2.0, {0, 0, 0.3}, BodyMotion::free, {40, 20, -50}),
          box({0.3, 0.2, 0.2}, other, {0.1, 0.06, 0}, BodyMotion::free, {0, -30, 10})};
      bodies[0].initial.velocity = {0, 0, -3};
      Simulation sim(net, bodies, initial_state(net, bodies));
      sim.configure({}, steps(h), barriers(0.2));
      const Vec3 p0 = linear_momentum(sim), l0 = angular_momentum(sim);
      const double e0 = kinetic_energy(sim);
      bool touched = false;
      run(sim, h, 150 * (1 + k), {}, [&](int) {
        touched = touched || !sim.contacts().empty();
        EXPECT_LT(kinetic_energy(sim) + sim.contact_energy(), e0 * (1.0 + 1e-9));
      });
      EXPECT_TRUE(touched) << other;
      EXPECT_LT((linear_momentum(sim) - p0).norm(), 1e-9 * p0.norm()) << other;
      drift[k] = (angular_momentum(sim) - l0).norm() / l0.norm();
      losses[k] = e0 - kinetic_energy(sim);
      EXPECT_GT(losses[k], 0.0);
    }
    EXPECT_LT(drift[1], std::max(0.7 * drift[0], 1e-9)) << other << " " << drift[0];
    RecordProperty("drift of angular momentum", std::to_string(drift[1]));
  }
}

// Held bodies are far away: threads fall through where they are drawn, but not through each other.
TEST(HeldBodies, TouchNothingWhileThreadsTouchEachOther) {
  Network net = two_masses({0, 0, 0.01});
  net.design.insert(net.design.end(), {Vec3(-0.05, 0, 0.02), Vec3(0.05, 0, 0.02)});
  net.initial = net.design;
  net.velocity = {{0, 0, 0}, {0, 0, 0}, {0, 0, -0.5}, {0, 0, -0.5}};
  net.mass.resize(4, 0.5);
  add_thread(net, {2, 3}, {0.1}, 0.0);
  const std::vector<Body> bodies{fixed_plane()};
  Simulation sim(net, bodies, initial_state(net, bodies));
  ContactSpec contact = barriers();
  contact.self = true;
  sim.configure({{0, 0, -9.81}, 0.0}, steps(2e-3), contact);
  sim.hold_bodies(true);
  run(sim, 2e-3, 50);
  EXPECT_LT(sim.state().x[0].z(), -0.03);
  EXPECT_GT(sim.state().x[2].z() - sim.state().x[0].z(), 2.0 * kRadius);
  EXPECT_LT(sim.state().v[2].z() - sim.state().v[0].z(), 0.5);
}

}  // namespace
}  // namespace retiarius

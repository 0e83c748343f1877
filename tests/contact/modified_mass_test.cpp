#include "retiarius/contact/modified_mass.hpp"

#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/contact/scene.hpp"
#include "tests/forces/derivatives.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// Whether a node that is nowhere in contact keeps clear of all bodies on its straight way through a
// step relative to them.
bool keeps_clear(const Vec3& start, const Vec3& end, const std::vector<Body>& bodies,
                 const std::vector<BodyState>& from, const std::vector<BodyState>& to) {
  constexpr int kSamples = 200;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Vec3 first = to_body(from[b], start), last = to_body(to[b], end);
    for (int k = 0; k <= kSamples; ++k) {
      const Vec3 p = first + (last - first) * k / kSamples;
      if (bodies[b].shape->nearest(p).distance < 0.95 * kRadius) return false;
    }
  }
  return true;
}

// What a response remembers of distances spares it questions to shapes: one that is new in each
// step and has to ask finds the same contacts, and neither overlooks a node that enters only after
// a revision.
TEST(ModifiedMass, RemembersDistancesThatChangeNothing) {
  constexpr int kNodes = 60, kSteps = 60;
  const double h = 0.01;
  const std::vector<Body> bodies{
      box({0.5, 0.3, 0.1}, 2.0, {0, 0, 0}, BodyMotion::free, {90, 60, 0}),
      sphere(0.2, 1.0, {0.5, 0, 0})};
  const std::vector<double> radius(kNodes, kRadius), mass(kNodes, 0.01);
  ModifiedMass kept(bodies, radius, mass, touching(0.2));
  Random random(5);
  State state;
  for (int i = 0; i < kNodes; ++i) {
    state.x.push_back(random.vector(1.0));
    state.v.push_back(random.vector(3.0));
  }
  for (const Body& b : bodies) state.bodies.push_back(b.initial);
  const std::vector<bool> held(kNodes, false);
  const std::vector<Vec3> reaction(kNodes, Vec3::Zero());
  std::size_t found = 0, clear = 0;
  for (int k = 0; k < kSteps; ++k) {
    const Step step = make_step(Method::implicit_euler, state, h);
    std::vector<BodyState> ends = state.bodies;
    for (BodyState& b : ends) b = displaced(b, random.vector(0.02), random.vector(0.05));
    std::vector<Vec3> predicted = state.x;
    for (int i = 0; i < kNodes; ++i) predicted[i] += h * state.v[i];
    ModifiedMass fresh(bodies, radius, mass, touching(0.2));
    kept.begin(step, predicted, ends, held);
    fresh.begin(step, predicted, ends, held);
    for (int revision = 0; revision < 3; ++revision) {
      const auto &a = kept.constraints(), &b = fresh.constraints();
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t c = 0; c < a.size(); ++c) {
        EXPECT_EQ(a[c].node, b[c].node);
        EXPECT_EQ(a[c].body, b[c].body);
        EXPECT_EQ(a[c].target, b[c].target);
      }
      found += a.size();
      predicted = random.disturbed(predicted, 0.01);
      kept.revise(predicted, ends, reaction, false);
      fresh.revise(predicted, ends, reaction, false);
      std::vector<bool> touches(kNodes, false);
      for (const Constraint& c : kept.constraints()) touches[c.node] = true;
      for (int i = 0; i < kNodes; ++i) {
        if (touches[i]) continue;
        EXPECT_TRUE(keeps_clear(state.x[i], predicted[i], bodies, state.bodies, ends)) << i;
        ++clear;
      }
    }
    // Nodes that have entered turn round.
    for (const Constraint& c : kept.constraints()) {
      predicted[c.node] = state.x[c.node];
      state.v[c.node] = -state.v[c.node];
    }
    for (int i = 0; i < kNodes; ++i)
      if (predicted[i].norm() > 1.0) state.v[i] = -3.0 * predicted[i].normalized();
    state.x = predicted;
    state.bodies = ends;
  }
  EXPECT_GT(found, 100u);
  EXPECT_GT(clear, 1000u);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/state/step.hpp"

#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"

namespace retiarius {
namespace {

State one_node() {
  State s;
  s.x = {Vec3(1.0, 2.0, 3.0)};
  s.v = {Vec3(0.5, -1.0, 2.0)};
  return s;
}

// A stage moved by d away from the prediction needs the force m * inertia * d; the velocity at the
// step's end then differs by that force's impulse over m. Follows the definitions of the stage.
TEST(Step, ReactionImpulseIsWhatChangesTheEndVelocity) {
  const State start = one_node();
  const double h = 0.125;
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint}) {
    const Step step = make_step(method, start, h);
    const Vec3 predicted = first_guess(method, step)[0];
    const Vec3 d(0.01, 0.02, -0.03);
    const auto end_velocity = [&](const Vec3& y) {
      return Vec3(start.v[0] + step.reach * (step.stage_velocity(0, y) - start.v[0]));
    };
    EXPECT_NEAR((end_velocity(predicted) - start.v[0]).norm(), 0.0, 1e-14) << to_string(method);
    const Vec3 impulse = step.reaction_impulse() * step.inertia * d;
    EXPECT_NEAR((end_velocity(predicted + d) - start.v[0] - impulse).norm(), 0.0, 1e-14)
        << to_string(method);
  }
}

TEST(Step, StageVelocityFollowsFromThePositions) {
  const State start = one_node();
  const Vec3 y = start.x[0] + Vec3(0.1, 0.0, 0.0);
  EXPECT_NEAR(make_step(Method::implicit_euler, start, 0.1).stage_velocity(0, y).x(), 1.0, 1e-13);
  // Average acceleration and midpoint: the velocity that, averaged with (Newmark) or half of
  // (midpoint: stage velocity is 2 (y - x0) / h) the start's, covers the way.
  EXPECT_NEAR(make_step(Method::newmark, start, 0.1).stage_velocity(0, y).x(), 1.5, 1e-13);
  EXPECT_NEAR(make_step(Method::midpoint, start, 0.1).stage_velocity(0, y).x(), 2.0, 1e-13);
}

TEST(Step, StaticStepsHaveNoVelocity) {
  const State start = one_node();
  const Step step = make_step(Method::static_solve, start, 0.1);
  EXPECT_EQ(step.stage_velocity(0, Vec3(9.0, 9.0, 9.0)), Vec3(Vec3::Zero()));
  EXPECT_EQ(first_guess(Method::static_solve, step)[0], start.x[0]);
}

}  // namespace
}  // namespace retiarius

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
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint,
                        Method::generalised_alpha, Method::tr_bdf2}) {
    const Step step = make_step(method, start, h);
    const Vec3 predicted = first_guess(method, step)[0];
    const Vec3 d(0.01, 0.02, -0.03);
    const auto end_velocity = [&](const Vec3& y) {
      return Vec3(start.v[0] + step.reach * (step.stage_velocity(0, y) - start.v[0]));
    };
    EXPECT_NEAR((end_velocity(predicted) - start.v[0]).norm(), 0.0, 1e-14) << to_string(method);
    const Vec3 impulse = step.reaction_impulse() * step.inertia * d;
    // The position's rounding, times the rate.
    const double rounding = 2e-16 * step.rate * step.reach * start.x[0].norm();
    EXPECT_NEAR((end_velocity(predicted + d) - start.v[0] - impulse).norm(), 0.0,
                std::max(1e-14, rounding))
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

// Uniformly accelerated motion by each scheme: the stage that the constant force of m a asks for
// gives the exact end position and velocity, whatever rho.
TEST(Step, GeneralisedAlphaIsExactForAConstantForce) {
  const State start = one_node();
  const Vec3 a(0.3, -9.81, 2.0);
  const double h = 0.125;
  for (double rho : {0.0, 0.5, 0.9, 1.0}) {
    Step step = make_step(Method::generalised_alpha, start, h, rho);
    const std::vector<Vec3> drift = alpha_drift(rho, step, {a});
    step.drift = &drift;
    const Vec3 y = predicted_stage(Method::generalised_alpha, step, {a}, rho)[0] + a / step.inertia;
    const Vec3 x1 = start.x[0] + step.reach * (y - start.x[0]);
    const Vec3 v1 = start.v[0] + step.reach * (step.stage_velocity(0, y) - start.v[0]);
    EXPECT_NEAR((x1 - start.x[0] - h * start.v[0] - 0.5 * h * h * a).norm(), 0.0, 1e-14) << rho;
    EXPECT_NEAR((v1 - start.v[0] - h * a).norm(), 0.0, 1e-14) << rho;
  }
}

TEST(Step, SecondStageOfTrBdf2IsExactForAConstantForce) {
  State start = one_node();
  const State before = start;
  const Vec3 a(0.3, -9.81, 2.0);
  const double h = 0.125, first = tr_bdf2::kGamma * h;
  start.x[0] += first * start.v[0] + 0.5 * first * first * a;
  start.v[0] += first * a;
  Bdf2Step second;
  make_bdf2_step(start, h, {first * a}, {first * a}, second);
  const Step& step = second.step;
  const Vec3 y = second.predicted[0] + a / step.inertia;
  EXPECT_NEAR((step.stage_velocity(0, y) - before.v[0] - h * a).norm(), 0.0, 1e-14);
  EXPECT_NEAR((y - before.x[0] - h * before.v[0] - 0.5 * h * h * a).norm(), 0.0, 1e-14);
  EXPECT_NEAR(step.h + first, h, 1e-16);
}

// Chung and Hulbert's table: rho 1 is the average acceleration with its force in the middle.
TEST(Step, ParametersOfGeneralisedAlpha) {
  const GeneralisedAlpha one = generalised_alpha(1.0);
  EXPECT_DOUBLE_EQ(one.alpha_m, 0.5);
  EXPECT_DOUBLE_EQ(one.alpha_f, 0.5);
  EXPECT_DOUBLE_EQ(one.beta, 0.25);
  EXPECT_DOUBLE_EQ(one.gamma, 0.5);
  const GeneralisedAlpha none = generalised_alpha(0.0);
  EXPECT_DOUBLE_EQ(none.alpha_m, -1.0);
  EXPECT_DOUBLE_EQ(none.alpha_f, 0.0);
  EXPECT_DOUBLE_EQ(none.beta, 1.0);
  EXPECT_DOUBLE_EQ(none.gamma, 1.5);
}

TEST(Step, StaticStepsHaveNoVelocity) {
  const State start = one_node();
  const Step step = make_step(Method::static_solve, start, 0.1);
  EXPECT_EQ(step.stage_velocity(0, Vec3(9.0, 9.0, 9.0)), Vec3(Vec3::Zero()));
  EXPECT_EQ(first_guess(Method::static_solve, step)[0], start.x[0]);
}

}  // namespace
}  // namespace retiarius

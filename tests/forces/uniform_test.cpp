// Gravity and environmental damping: the laws that act on each node alone.
#include <gtest/gtest.h>

#include "retiarius/forces/environment_damping.hpp"
#include "retiarius/forces/gravity.hpp"
#include "retiarius/motion/integrator.hpp"
#include "tests/forces/derivatives.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

State two_nodes(Random& random) {
  State s;
  s.x = {random.vector(), random.vector()};
  s.v = {random.vector(), random.vector()};
  return s;
}

TEST(Gravity, GradientIsMinusWeight) {
  Random random(1);
  const State start = two_nodes(random);
  const Step step = make_step(Method::implicit_euler, start, 0.01);
  Gravity law({0.5, 2.0}, Vec3(1.0, 2.0, -9.81));
  const std::vector<Vec3> g = gradient_of(law, step, start.x);
  EXPECT_EQ(g[1], Vec3(-2.0 * Vec3(1.0, 2.0, -9.81)));
  const std::vector<Vec3> y = random.disturbed(start.x, 0.1);
  // The potential is linear: differences leave round-off only. There is no Hessian.
  EXPECT_LT(compare_derivatives(law, step, y, 1e-2).gradient, 1e-12);
  EXPECT_EQ(hessian_of(law, step, y, false).cwiseAbs().maxCoeff(), 0.0);
}

TEST(EnvironmentDamping, DerivativesAgreeWithFiniteDifferences) {
  Random random(2);
  const State start = two_nodes(random);
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint}) {
    const Step step = make_step(method, start, 0.05);
    EnvironmentDamping law({0.5, 2.0}, 0.7);
    const std::vector<Vec3> y = random.disturbed(start.x, 0.1);
    const Mismatch m = compare_derivatives(law, step, y, 1e-2);
    EXPECT_LT(m.gradient, 1e-11);  // quadratic: round-off only
    EXPECT_LT(m.hessian, 1e-11);
  }
}

TEST(EnvironmentDamping, ForceIsMinusMuMassVelocity) {
  Random random(3);
  const State start = two_nodes(random);
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint}) {
    const Step step = make_step(method, start, 0.05);
    EnvironmentDamping law({0.5, 2.0}, 0.7);
    const std::vector<Vec3> g = gradient_of(law, step, first_guess(method, step));
    EXPECT_NEAR((g[1] - 0.7 * 2.0 * start.v[1]).norm(), 0.0, 1e-13) << to_string(method);
  }
}

TEST(EnvironmentDamping, DoesNotActOnStaticSolves) {
  Random random(4);
  const State start = two_nodes(random);
  const Step step = make_step(Method::static_solve, start, 0.05);
  EnvironmentDamping law({0.5, 2.0}, 0.7);
  EXPECT_EQ(gradient_of(law, step, random.disturbed(start.x, 0.1))[0], Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace retiarius

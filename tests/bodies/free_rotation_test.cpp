#include "retiarius/bodies/free_rotation.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "tests/bodies/random_points.hpp"

namespace retiarius {
namespace {

double angle_between(const Quat& a, const Quat& b) {
  return 2.0 * (a.conjugate() * b).vec().norm();  // rad, for small angles
}

TEST(Rotation, TurnsAboutTheVectorByItsLength) {
  const Quat quarter = rotation(Vec3(0.0, 0.0, kPi / 2.0));
  EXPECT_LT((quarter * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_TRUE(rotation(Vec3::Zero()).isApprox(Quat::Identity(), 0.0));
  // Both sides of the series' threshold follow the same formula.
  for (const double angle : {0.99e-4, 1.01e-4}) {
    EXPECT_NEAR(rotation(Vec3(angle, 0.0, 0.0)).x(), std::sin(0.5 * angle), 1e-20);
  }
}

TEST(TurnFreely, HasOrderFour) {
  const Mat3 inverse = Vec3(1.0, 1.0 / 2.0, 1.0 / 3.0).asDiagonal();
  const Vec3 momentum(0.4, 1.9, 0.8);
  const Quat start = rotation(Vec3(0.3, -0.5, 0.2));
  const Quat exact = turn_freely(inverse, start, momentum, 2.0, 4096);
  double before = 0.0;
  for (const int substeps : {8, 16, 32, 64}) {
    const double error = angle_between(turn_freely(inverse, start, momentum, 2.0, substeps), exact);
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / error), 4.0, 0.25) << substeps;
    }
    before = error;
  }
}

// R(t) of a body with I = (A, A, C): a turn about the fixed momentum by L t / A, and a turn about
// the body's own axis by (1/C - 1/A) L_3 t.
TEST(TurnFreely, FollowsTheSteadyPrecessionOfAnAxisymmetricBody) {
  const double a = 2.0, c = 0.7, t = 1.7;
  const Mat3 inverse = Vec3(1.0 / a, 1.0 / a, 1.0 / c).asDiagonal();
  const Quat start = rotation(Vec3(0.8, 0.1, -0.4));
  const Vec3 momentum(0.5, -1.2, 2.0);
  const double along = (start.conjugate() * momentum).z();
  const Quat exact = rotation(momentum * (t / a)) * start *
                     rotation(Vec3(0.0, 0.0, (1.0 / c - 1.0 / a) * along * t));
  EXPECT_LT(angle_between(turn_freely(inverse, start, momentum, t, 400), exact), 1e-9);
}

TEST(FreeRotationSubsteps, KeepTheErrorOfAStepBelowTheirPromise) {
  test::RandomPoints random(3);
  for (const double angle : {1e-3, 1e-2, 0.05, 0.2, 1.0, 5.0}) {
    for (int k = 0; k < 60; ++k) {
      // Moments that a body can have: sums of two of three positive numbers.
      const Vec3 part(random.within(0.001, 1.0), random.within(0.001, 1.0),
                      random.within(0.001, 1.0));
      const Vec3 moments = Vec3::Constant(part.sum()) - part;
      const Vec3 momentum = random.direction() * angle * moments.minCoeff();
      const Mat3 inverse = moments.cwiseInverse().asDiagonal();
      const int substeps = free_rotation_substeps(angle);
      const Quat coarse = turn_freely(inverse, Quat::Identity(), momentum, 1.0, substeps);
      const Quat fine = turn_freely(inverse, Quat::Identity(), momentum, 1.0, 8 * substeps);
      EXPECT_LT(angle_between(coarse, fine), 1e-10) << angle << ": " << moments.transpose();
    }
  }
}

TEST(FreeRotationSubsteps, GrowOnlyWhereNeededAndRefuseTheAbsurd) {
  EXPECT_EQ(free_rotation_substeps(0.0), 1);
  EXPECT_EQ(free_rotation_substeps(0.01), 1);
  EXPECT_GT(free_rotation_substeps(1.0), 100);
  EXPECT_LT(free_rotation_substeps(1.0), 300);
  EXPECT_THAT(
      [] { free_rotation_substeps(1e4); },
      testing::ThrowsMessage<RunError>("a body turns by 1e+04 rad in one step; at most 1000 "
                                       "rad can be followed: reduce the step or its spin"));
  EXPECT_THROW(free_rotation_substeps(std::nan("")), RunError);
}

}  // namespace
}  // namespace retiarius

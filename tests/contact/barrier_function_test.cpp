// The scalar functions of barrier contact.
#include "retiarius/contact/barrier_function.hpp"

#include <gtest/gtest.h>

namespace retiarius {
namespace {

TEST(Barrier, HasTheDerivativesItStates) {
  const double range = 2e-4;
  for (double share : {0.01, 0.1, 0.3, 0.7, 0.95, 0.999}) {
    const double g = share * range, e = 1e-5 * std::min(g, range - g);
    const Jet at = barrier(g, range), up = barrier(g + e, range), down = barrier(g - e, range);
    EXPECT_NEAR((up.value - down.value) / (2 * e), at.first, 1e-7 * std::abs(at.first));
    EXPECT_NEAR((up.first - down.first) / (2 * e), at.second, 1e-7 * at.second) << share;
    EXPECT_GT(at.value, 0.0);
    EXPECT_LT(at.first, 0.0);
    EXPECT_GT(at.second, 0.0);
  }
}

TEST(Barrier, BeginsSmoothlyAtItsRangeAndIsInfiniteAtContact) {
  const Jet end = barrier(1.0 - 1e-9, 1.0);
  EXPECT_NEAR(end.value, 0.0, 1e-25);
  EXPECT_NEAR(end.first, 0.0, 1e-17);
  EXPECT_NEAR(end.second, 0.0, 1e-8);
  EXPECT_EQ(barrier(1.0, 1.0).value, 0.0);
  EXPECT_EQ(barrier(0.0, 1.0).value, kInfinity);
  EXPECT_EQ(barrier(-0.1, 1.0).value, kInfinity);
  EXPECT_EQ(barrier(std::numeric_limits<double>::quiet_NaN(), 1.0).value, kInfinity);
}

TEST(Barrier, GapOfAForceIsTheInverseOfTheForce) {
  const double range = 2e-4;
  for (double share : {1e-9, 1e-4, 0.01, 0.3, 0.9, 0.9999}) {
    const double gap = share * range, force = -barrier(gap, range).first;
    EXPECT_NEAR(gap_of_force(force, range), gap, 1e-10 * gap) << share;
  }
  EXPECT_EQ(gap_of_force(0.0, range), range);
}

TEST(ForetoldBarrier, IsTheBarrierWhereItsOwnForceIsForetold) {
  const double range = 2e-4;
  for (double share : {0.01, 0.5, 0.99}) {
    const Jet own = barrier(share * range, range);
    const Jet foretold = foretold_barrier(share * range, range, -own.first);
    EXPECT_EQ(foretold.value, own.value);
    EXPECT_EQ(foretold.first, own.first);
    EXPECT_EQ(foretold.second, own.second);
    const Jet close = foretold_barrier(share * range, range, -1.001 * own.first);
    EXPECT_NEAR(close.second, own.second, 1e-2 * own.second) << share;
  }
}

TEST(ForetoldBarrier, TellsForceAndCurvatureOfTheWayToTheGapWanted) {
  const double range = 2e-4, from = 0.05 * range;
  const Jet here = barrier(from, range);
  for (double to : {0.02 * range, 0.1 * range, 0.4 * range}) {
    const double force = -barrier(to, range).first;
    const Jet foretold = foretold_barrier(from, range, force);
    EXPECT_NEAR(foretold.first, -force, 1e-9 * force);
    EXPECT_NEAR(from - (here.first + force) / foretold.second, to, 1e-9 * to);
  }
}

// A force that vanishes or explodes is not believed at once.
TEST(ForetoldBarrier, BoundsTheChangeOfForce) {
  const double range = 2e-4, gap = 0.2 * range, own = -barrier(gap, range).first;
  EXPECT_DOUBLE_EQ(foretold_barrier(gap, range, 0.0).first, -own / 50.0);
  EXPECT_DOUBLE_EQ(foretold_barrier(gap, range, 1e9 * own).first, -50.0 * own);
  EXPECT_GT(foretold_barrier(gap, range, 0.0).second, 0.0);
}

// A mass that a constant force presses on a surface, from a gap a tenth of that at rest: the
// first step only doubles it, but tells the force, and the second gets there.
TEST(ForetoldBarrier, LeadsToRestInTwoSteps) {
  const double range = 2e-4, rest = 0.5 * range, load = -barrier(rest, range).first;
  double gap = 0.1 * rest;
  double foretold = -barrier(gap, range).first;
  for (int step = 0; step < 2; ++step) {
    const Jet b = foretold_barrier(gap, range, foretold);
    const double push = -barrier(gap, range).first;
    const double way = (push - load) / b.second;
    foretold = push - b.second * way;
    gap += way;
    if (step == 0) {
      EXPECT_LT(gap, 0.25 * rest);
    }
  }
  EXPECT_NEAR(gap, rest, 1e-9 * rest);
}

TEST(SmoothSlip, HasTheDerivativesItStatesAndCoulombsLimit) {
  const double s = 1e-5;
  for (double u : {0.01 * s, 0.5 * s, 0.99 * s, 1.01 * s, 20.0 * s}) {
    const double e = 1e-6 * u;
    const SlipJet at = smooth_slip(u, s), up = smooth_slip(u + e, s), down = smooth_slip(u - e, s);
    EXPECT_NEAR((up.value - down.value) / (2 * e), at.first, 1e-8);
    EXPECT_NEAR((up.first - down.first) / (2 * e), at.second, 1e-6 / s);
    EXPECT_NEAR(at.over, at.first / u, 1e-12 / s);
  }
  EXPECT_EQ(smooth_slip(0.0, s).first, 0.0);
  EXPECT_EQ(smooth_slip(0.0, s).over, 2.0 / s);
  EXPECT_EQ(smooth_slip(s, s).first, 1.0);
}

TEST(ShareOfNewton, IsTheCosineOfTheTurnButNotNegative) {
  const Vec3 u(1e-3, 0, 0);
  EXPECT_EQ(share_of_newton(Vec3::Zero(), u), 1.0);
  EXPECT_EQ(share_of_newton(u, Vec3::Zero()), 1.0);
  EXPECT_DOUBLE_EQ(share_of_newton(u, 5.0 * u), 1.0);
  EXPECT_DOUBLE_EQ(share_of_newton(u, Vec3(2, 2, 0)), std::sqrt(0.5));
  EXPECT_EQ(share_of_newton(u, -u), 0.0);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/contact/advance.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/bodies/body.hpp"
#include "retiarius/contact/distance.hpp"
#include "tests/contact/pair_samples.hpp"

namespace retiarius {
namespace {

using testing::Stream;

// Motion of a random pair: nodes on one side or both, bodies on the others.
PairMotion random_motion(Stream& random, PairKind kind) {
  PairMotion motion{kind, {}};
  const PairPositions p = testing::sample_pair(random);
  const double speed = random.scale(1e-3, 10.0);
  const int rigid = random.integer(3);  // none, the second, both
  BodyTwist bodies[2];
  for (BodyTwist& body : bodies) {
    body.position = random.vector();
    body.translation = random.vector(speed);
    body.rotation = random.vector(random.scale(1e-4, 2.0));
  }
  const Vec3 common = random.vector(speed);
  for (int i = 0; i < point_count(kind); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const bool second = i >= first_count(kind);
    if (second ? rigid >= 1 : rigid == 2) {
      const BodyTwist& body = bodies[second ? 1 : 0];
      motion.points[k] = body_point_motion(body, p[k] - body.position);
    } else {
      motion.points[k] = node_motion(p[k], common + random.vector(speed));
    }
  }
  return motion;
}

// The first of finely spaced times at which the distance is below `bound`; 1 where there is none.
double first_below(const PairMotion& motion, double bound, int samples, double until) {
  for (int k = 0; k <= samples; ++k) {
    const double t = until * k / samples;
    if (distance(motion.kind, motion.at(t)).value < bound) return t;
  }
  return 1.0;
}

TEST(Advance, IsNeverLaterThanTheFirstContactOfAFineSampling) {
  Stream random(11);
  int contacts = 0, free = 0;
  for (int k = 0; k < 10000; ++k) {
    const PairKind kind = testing::kBoundedKinds[k % 4];
    const PairMotion motion = random_motion(random, kind);
    const double start = distance(kind, motion.at(0.0)).value;
    const double separation = start * random.uniform(0.0, 0.99);
    const double t = advance(motion, separation, 0.1);
    // Below this a gap is lost in the rounding of places up to 200 m away.
    if (start - separation <= 1e-9) continue;
    ASSERT_GT(t, 0.0) << k;
    const double bound = separation + 0.1 * (start - separation);
    // All of the way that was allowed keeps the bound, up to rounding in the sampling itself.
    const double rounding = 1e-14 * (1.0 + motion.at(0.0)[0].norm());
    ASSERT_GE(first_below(motion, bound - rounding, 400, t), 1.0) << k << " " << t;
    (t < 1.0 ? contacts : free)++;
  }
  EXPECT_GT(contacts, 1000);
  EXPECT_GT(free, 1000);
}

// Not only safe: it stops where the bound is met, not before.
TEST(Advance, ReachesTheBound) {
  Stream random(12);
  int stopped = 0, short_of = 0;
  for (int k = 0; k < 40000; ++k) {
    const PairKind kind = testing::kBoundedKinds[k % 4];
    const PairMotion motion = random_motion(random, kind);
    const double start = distance(kind, motion.at(0.0)).value;
    if (start < 1e-6) continue;
    const double separation = 0.5 * start;
    const double t = advance(motion, separation, 0.1);
    if (t >= 1.0) continue;
    ++stopped;
    const double reached = distance(kind, motion.at(t)).value;
    if (reached > separation + 0.15 * (start - separation)) ++short_of;
  }
  EXPECT_GT(stopped, 500);
  EXPECT_EQ(short_of, 0);
}

TEST(Advance, OfAPointOnATriangleIsTheAnalyticTime) {
  PairMotion motion{PairKind::point_triangle, {}};
  motion.points[0] = node_motion(Vec3(0.2, 0.2, 1.0), Vec3(0.1, 0.0, -4.0));
  motion.points[1] = node_motion(Vec3(0, 0, 0), Vec3::Zero());
  motion.points[2] = node_motion(Vec3(1, 0, 0), Vec3::Zero());
  motion.points[3] = node_motion(Vec3(0, 1, 0), Vec3::Zero());
  // The distance 1 - 4 t falls to 0.2 + 0.1 * 0.8 at 0.18.
  EXPECT_NEAR(advance(motion, 0.2, 0.1), 0.18 / 1.0, 0.01);
  EXPECT_LE(advance(motion, 0.2, 0.1), 0.18);
}

// A thread at 20 m/s through a panel of 1 mm within one step of 10 ms: 200 times its thickness.
TEST(Advance, SeesAThinPanel) {
  PairMotion motion{PairKind::edge_edge, {}};
  motion.points[0] = node_motion(Vec3(-1, 0.02, 0.1), Vec3(0, 0, -0.2));
  motion.points[1] = node_motion(Vec3(1, -0.01, 0.1), Vec3(0, 0, -0.2));
  motion.points[2] = node_motion(Vec3(0, -1, 0), Vec3::Zero());
  motion.points[3] = node_motion(Vec3(0, 1, 0), Vec3::Zero());
  const double t = advance(motion, 0.5e-3, 0.1);
  EXPECT_LE(t, (0.1 - 0.5e-3) * 0.9 / 0.2);
  EXPECT_GT(t, 0.49 * 0.9);
}

// Gliding along a face close to it costs few advances: the face's plane stays a bound.
TEST(Advance, IsFreeAlongAFace) {
  PairMotion motion{PairKind::point_triangle, {}};
  motion.points[0] = node_motion(Vec3(-3, 0.2, 1e-6), Vec3(6, 0.1, 0.0));
  motion.points[1] = node_motion(Vec3(-5, -5, 0), Vec3::Zero());
  motion.points[2] = node_motion(Vec3(5, -5, 0), Vec3::Zero());
  motion.points[3] = node_motion(Vec3(0, 9, 0), Vec3::Zero());
  EXPECT_EQ(advance(motion, 0.0, 0.1), 1.0);
}

// Edges that lie nearly parallel and glide or close in: the time is analytic whatever the angle.
TEST(Advance, OfNearlyParallelEdges) {
  for (const double angle : {0.0, 1e-16, 1e-13, 1e-11, 1e-9, 1e-7, 1e-4}) {
    PairMotion motion{PairKind::edge_edge, {}};
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
    motion.points[0] = node_motion(Vec3(-1, 0, 0.5), Vec3(0.3, 0.1, -2.0));
    motion.points[1] = node_motion(Vec3(1, 0, 0.5), Vec3(0.3, 0.1, -2.0));
    motion.points[2] = node_motion(-along, Vec3(0.3, 0.1, 0.0));
    motion.points[3] = node_motion(along, Vec3(0.3, 0.1, 0.0));
    // 0.5 - 2 t falls to 0.1 + 0.1 * 0.4 at 0.18.
    const double t = advance(motion, 0.1, 0.1);
    EXPECT_LE(t, 0.18) << angle;
    EXPECT_GT(t, 0.175) << angle;
  }
}

TEST(Advance, OfAPointOnAPlane) {
  PairMotion motion{PairKind::point_plane, {}};
  motion.points[0] = node_motion(Vec3(1, 2, 3), Vec3(50, 0, -2));
  motion.points[1] = node_motion(Vec3(0, 0, 2), Vec3::Zero());
  motion.points[2] = node_motion(Vec3(0, 0, 3), Vec3::Zero());
  // 1 - 2 t falls to 0.1 at 0.45.
  EXPECT_LE(advance(motion, 0.0, 0.1), 0.45);
  EXPECT_GT(advance(motion, 0.0, 0.1), 0.44);
  motion.points[0] = node_motion(Vec3(1, 2, 3), Vec3(50, 0, 0));
  EXPECT_EQ(advance(motion, 0.5, 0.1), 1.0);
  motion.points[0] = node_motion(Vec3(1, 2, 1.9), Vec3::Zero());
  EXPECT_EQ(advance(motion, 0.0, 0.1), 0.0);
}

// A corner of a turning body sweeps an arc: the chord misses a point that the arc hits.
TEST(Advance, FollowsTheArcOfATurn) {
  BodyTwist body;
  body.rotation = Vec3(0, 0, kPi / 2);
  PairMotion motion{PairKind::point_point, {}};
  const double half = std::sqrt(0.5);
  motion.points[0] = node_motion(Vec3(half, half, 0), Vec3::Zero());
  motion.points[1] = body_point_motion(body, Vec3(1, 0, 0));
  const double t = advance(motion, 0.01, 0.1);
  const double start = std::sqrt(2.0 - 2.0 * half);
  const double bound = 0.01 + 0.1 * (start - 0.01);
  EXPECT_LE(t, 0.5 - 2.0 * std::asin(0.5 * bound) / (kPi / 2));
  EXPECT_GT(t, 0.43);
}

TEST(MotionBetween, LeadsFromStartToEnd) {
  Stream random(13);
  for (int k = 0; k < 200; ++k) {
    BodyState start, end;
    start.position = random.vector();
    end.position = random.vector();
    start.attitude = Quat(Eigen::AngleAxisd(random.uniform(0, 3), random.direction()));
    const double angle = random.scale(1e-14, 3.1);
    end.attitude = Quat(Eigen::AngleAxisd(angle, random.direction())) * start.attitude;
    if (k % 2) end.attitude.coeffs() = -end.attitude.coeffs();
    const BodyTwist twist = motion_between(start, end);
    EXPECT_NEAR(twist.rotation.norm(), angle, 1e-14);
    const Vec3 p = random.vector();
    EXPECT_LT((body_point_motion(twist, p).at(1.0) - to_world(end, p)).norm(), 1e-14);
    EXPECT_LT((body_point_motion(twist, p).at(0.0) - to_world(start, p)).norm(), 1e-14);
  }
}

TEST(PointMotion, HasItsVelocityAndAcceleration) {
  BodyTwist body;
  body.position = Vec3(1, 2, 3);
  body.translation = Vec3(0.3, -0.2, 0.1);
  body.rotation = Vec3(0.5, -0.7, 1.1);
  const PointMotion point = body_point_motion(body, Vec3(0.4, 0.5, -0.6));
  constexpr double kStep = 1e-4;
  for (const double t : {0.0, 0.3, 1.0}) {
    const Vec3 slope = (point.at(t + kStep) - point.at(t - kStep)) / (2 * kStep);
    EXPECT_LT((slope - point.velocity(t)).norm(), 1e-7);
    const double bend =
        ((point.velocity(t + kStep) - point.velocity(t - kStep)) / (2 * kStep)).norm();
    EXPECT_NEAR(bend, point.largest_acceleration(), 1e-7);
  }
}

}  // namespace
}  // namespace retiarius

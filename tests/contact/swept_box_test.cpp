#include "retiarius/contact/swept_box.hpp"

#include <gtest/gtest.h>

#include "tests/contact/pair_samples.hpp"

namespace retiarius {
namespace {

using testing::Stream;

BodyTwist random_twist(Stream& random) {
  BodyTwist twist;
  twist.position = random.vector();
  twist.attitude = Quat(Eigen::AngleAxisd(random.uniform(0.0, 3.0), random.direction()));
  twist.translation = random.vector();
  twist.rotation = random.uniform(0.0, 2.5) * random.direction();
  return twist;
}

// How far the path, as the axes see it, leaves the box at most.
double leaves(const Box& box, const PointMotion& point, const BodyTwist& axes) {
  double worst = 0.0;
  for (int k = 0; k <= 64; ++k) {
    const double t = k / 64.0;
    const Vec3 away = point.at(t) - axes.position - t * axes.translation;
    const double angle = axes.rotation.norm();
    const Mat3 turn =
        Eigen::AngleAxisd(t * angle, axes.rotation / angle) * axes.attitude.toRotationMatrix();
    worst = std::max(worst, box.exteriorDistance(Vec3(turn.transpose() * away)));
  }
  return worst;
}

TEST(SweptBox, HoldsThePathOfNodesAndBodyPoints) {
  Stream random(51);
  for (int k = 0; k < 500; ++k) {
    const BodyTwist axes = random_twist(random), other = random_twist(random);
    for (const PointMotion& point : {node_motion(random.vector(), random.vector()),
                                     body_point_motion(other, random.vector())}) {
      const Box box = MovingAxes(axes).box(point);
      EXPECT_LE(leaves(box, point, axes), 1e-14);
    }
  }
}

TEST(SweptBox, OfStraightMotionInFixedAxesIsExact) {
  BodyTwist axes;
  axes.position = Vec3(1, 2, 3);
  const Box box = MovingAxes(axes).box(node_motion(Vec3(1, 2, 4), Vec3(-1, 0.5, 0)));
  EXPECT_LT((box.min() - Vec3(-1, 0, 1)).norm(), 1e-15);
  EXPECT_LT((box.max() - Vec3(0, 0.5, 1)).norm(), 1e-15);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/measure/hull.hpp"

#include <cmath>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/primitives.hpp"

namespace retiarius {
namespace {

std::vector<Vec3> box_corners(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k) {
    corners.emplace_back((k & 1) ? high.x() : low.x(), (k & 2) ? high.y() : low.y(),
                         (k & 4) ? high.z() : low.z());
  }
  return corners;
}

TriangleMesh unit_cube() { return make_box(Vec3::Ones())->triangles(); }

TEST(ConvexHull, OfABoxIsTheBox) {
  std::vector<Vec3> points = box_corners(Vec3(-1.0, 0.0, 2.0), Vec3(1.0, 3.0, 6.0));
  points.emplace_back(0.3, 1.2, 3.3);  // inside: changes nothing
  const auto hull = convex_hull(points);
  ASSERT_TRUE(hull.has_value());
  EXPECT_NEAR(hull->volume, 24.0, 1e-12);
  EXPECT_NEAR(hull->area, 2.0 * (6.0 + 8.0 + 12.0), 1e-12);
  EXPECT_TRUE(hull->contains(Vec3(0.9, 2.9, 5.9)));
  EXPECT_TRUE(hull->contains(points[0]));
  EXPECT_FALSE(hull->contains(Vec3(1.001, 1.0, 3.0)));
  EXPECT_FALSE(hull->contains(Vec3(0.0, -0.001, 3.0)));
  EXPECT_FALSE(hull->contains(Vec3(0.0, 1.0, 6.001)));
}

TEST(ConvexHull, HoldsItsPointsAlsoFarFromTheOrigin) {
  std::mt19937 engine(4);
  std::normal_distribution<double> normal;
  for (const double away : {0.0, 1e5}) {
    std::vector<Vec3> points;
    for (int k = 0; k < 2000; ++k) {
      points.emplace_back(away + normal(engine), normal(engine), normal(engine) - away);
    }
    const auto hull = convex_hull(points);
    ASSERT_TRUE(hull.has_value());
    for (const Vec3& p : points) EXPECT_TRUE(hull->contains(p));
    for (const auto& plane : hull->planes) EXPECT_NEAR(plane.normal.norm(), 1.0, 1e-14);
  }
}

TEST(ConvexHull, OfPointsOnASphereTendsToTheBall) {
  const auto hull = convex_hull(make_sphere(1.0)->triangles().vertices);
  ASSERT_TRUE(hull.has_value());
  EXPECT_NEAR(hull->volume, 4.0 / 3.0 * kPi, 0.02);
  EXPECT_NEAR(hull->area, 4.0 * kPi, 0.04);
}

TEST(ConvexHull, IsEmptyForWhatHasNoVolume) {
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  EXPECT_FALSE(convex_hull({}).has_value());
  EXPECT_FALSE(convex_hull({o, x, y}).has_value());
  EXPECT_FALSE(convex_hull({o, x, y, x + y, 0.3 * x + 0.1 * y}).has_value());
  EXPECT_FALSE(convex_hull({o, x, 2.0 * x, 3.0 * x, 4.0 * x}).has_value());
  EXPECT_FALSE(convex_hull({x, x, x, x, x, x}).has_value());
  EXPECT_TRUE(convex_hull({o, x, y, z}).has_value());
  // A flat net at an angle, whose points leave the plane by rounding only.
  std::vector<Vec3> net;
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()));
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) net.push_back(turn * Vec3(0.2 * i, 0.2 * j, 0.0));
  }
  EXPECT_FALSE(convex_hull(net).has_value());
}

// Many coplanar, repeated and nearly coplanar points, as folded nets have them.
TEST(ConvexHull, SurvivesNetsThatAreNearlyFlat) {
  std::mt19937 engine(8);
  std::normal_distribution<double> normal;
  for (const double height : {1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-6, 1e-2}) {
    for (const int levels : {1, 2, 3}) {
      std::vector<Vec3> net;
      for (int i = 0; i < 900 * levels; ++i) {
        const double z = i / 900 + height * normal(engine);
        net.emplace_back(5.0 + 0.2 * (i % 30), 0.2 * (i / 30 % 30), 4.0 + z);
        if (i % 7 == 0) net.push_back(net.back());
      }
      std::optional<ConvexHull> hull;
      ASSERT_NO_THROW(hull = convex_hull(net)) << height << " " << levels;
      if (levels > 1) {
        ASSERT_TRUE(hull.has_value());
        EXPECT_NEAR(hull->volume, 5.8 * 5.8 * (levels - 1), 0.1 + 300.0 * height);
      }
      if (!hull) continue;
      for (const Vec3& p : net) ASSERT_TRUE(hull->contains(p)) << height << " " << levels;
    }
  }
}

TEST(ConvexHull, RefusesPointsThatAreNotFinite) {
  std::vector<Vec3> points = box_corners(Vec3::Zero(), Vec3::Ones());
  points[3].y() = std::nan("");
  EXPECT_THAT([&] { convex_hull(points); },
              testing::ThrowsMessage<RunError>("the convex hull needs points that are finite"));
}

TEST(ConvexHull, PrintsNothing) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  convex_hull(std::vector<Vec3>(10, Vec3::Ones()));
  convex_hull(box_corners(Vec3::Zero(), Vec3::Ones()));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(ConvexHull, MayRunInSeveralThreads) {
  const std::vector<Vec3> points = make_sphere(1.0)->triangles().vertices;
  const double expected = convex_hull(points)->volume;
  std::vector<double> volumes(4, 0.0);
  std::vector<std::thread> threads;
  for (double& volume : volumes) {
    threads.emplace_back([&] { volume = convex_hull(points)->volume; });
  }
  for (auto& thread : threads) thread.join();
  for (const double volume : volumes) EXPECT_EQ(volume, expected);
}

double share(const TriangleMesh& surface, const BodyState& pose, const Vec3& low,
             const Vec3& high) {
  return captured_share(surface, pose, *convex_hull(box_corners(low, high)));
}

TEST(CapturedShare, IsExactForACubeAndABox) {
  const BodyState rest;
  const Vec3 far = Vec3::Constant(2.0);
  EXPECT_NEAR(share(unit_cube(), rest, -far, far), 1.0, 1e-14);
  EXPECT_NEAR(share(unit_cube(), rest, far, 2.0 * far), 0.0, 1e-14);
  EXPECT_NEAR(share(unit_cube(), rest, -far, Vec3(2.0, 2.0, 0.0)), 0.5, 1e-14);
  // One octant: three quarter faces of six.
  EXPECT_NEAR(share(unit_cube(), rest, Vec3::Zero(), far), 0.125, 1e-14);
  // A hull within the body holds nothing of its surface.
  EXPECT_NEAR(share(unit_cube(), rest, Vec3::Constant(-0.3), Vec3::Constant(0.3)), 0.0, 1e-14);
}

TEST(CapturedShare, FollowsThePose) {
  BodyState pose;
  pose.position = Vec3(10.0, 0.0, 0.0);
  const Vec3 low(9.0, -2.0, -2.0), high(11.0, 2.0, 0.25);
  EXPECT_NEAR(share(unit_cube(), pose, low, high), (1.0 + 4.0 * 0.75) / 6.0, 1e-14);
  // A quarter turn about x leaves a cube as it was; an eighth turn does not.
  pose.attitude = Quat(Eigen::AngleAxisd(kPi / 2.0, Vec3::UnitX()));
  EXPECT_NEAR(share(unit_cube(), pose, low, high), (1.0 + 4.0 * 0.75) / 6.0, 1e-14);
  pose.attitude = Quat(Eigen::AngleAxisd(kPi / 4.0, Vec3::UnitX()));
  // Above z = 1/4 the two end squares show a corner of height s = sqrt(1/2) - 1/4, area s^2, and
  // the four long faces lose two strips of width s sqrt(2).
  const double s = std::sqrt(0.5) - 0.25;
  EXPECT_NEAR(share(unit_cube(), pose, low, high),
              (6.0 - 2.0 * s * s - 2.0 * s * std::sqrt(2.0)) / 6.0, 1e-13);
}

// A zone of a sphere has the area 2 pi r h.
TEST(CapturedShare, OfASphereGoesWithTheHeight) {
  const TriangleMesh ball = make_sphere(1.0)->triangles();
  for (const double z : {-0.6, 0.0, 0.35, 0.9}) {
    const Vec3 far = Vec3::Constant(2.0);
    EXPECT_NEAR(share(ball, {}, -far, Vec3(2.0, 2.0, z)), (1.0 + z) / 2.0, 1e-3);
  }
}

}  // namespace
}  // namespace retiarius

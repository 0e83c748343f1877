#include "retiarius/bodies/triangle_nearest.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/bodies/random_points.hpp"

namespace retiarius {
namespace {

const Corners kTriangle = {Vec3(0.0, 0.0, 0.0), Vec3(2.0, 0.0, 0.0), Vec3(0.5, 1.5, 0.0)};

TEST(NearestOnTriangle, NamesTheFeature) {
  const auto feature = [](double x, double y) {
    return nearest_on_triangle(Vec3(x, y, 0.7), kTriangle).feature;
  };
  EXPECT_EQ(feature(0.8, 0.5), Feature::face);
  EXPECT_EQ(feature(1.0, -1.0), Feature::edge0);
  EXPECT_EQ(feature(2.0, 1.5), Feature::edge1);
  EXPECT_EQ(feature(-0.5, 1.0), Feature::edge2);
  EXPECT_EQ(feature(-1.0, -1.0), Feature::corner0);
  EXPECT_EQ(feature(3.0, -1.0), Feature::corner1);
  EXPECT_EQ(feature(0.5, 3.0), Feature::corner2);
}

TEST(NearestOnTriangle, IsNoFartherThanAnySampleOfTheTriangle) {
  test::RandomPoints random(5);
  for (int k = 0; k < 300; ++k) {
    const Corners t = {random.in_cube(1.0), random.in_cube(1.0), random.in_cube(1.0)};
    const Vec3 p = random.in_cube(1.5);
    const double found = (p - nearest_on_triangle(p, t).point).norm();
    constexpr int kGrid = 80;
    double sampled = kInfinity;
    for (int i = 0; i <= kGrid; ++i) {
      for (int j = 0; i + j <= kGrid; ++j) {
        const Vec3 q = t[0] + (t[1] - t[0]) * i / kGrid + (t[2] - t[0]) * j / kGrid;
        sampled = std::min(sampled, (p - q).norm());
      }
    }
    const double spacing = std::max((t[1] - t[0]).norm(), (t[2] - t[0]).norm()) / kGrid;
    EXPECT_LE(found, sampled + 1e-14);
    EXPECT_GE(found, sampled - spacing);
  }
}

TEST(SegmentSegmentDistance, KnowsCrossingParallelAndPointLikeSegments) {
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  EXPECT_DOUBLE_EQ(segment_segment_distance(-x, x, z - y, z + y), 1.0);
  EXPECT_DOUBLE_EQ(segment_segment_distance(o, x, y, x + y), 1.0);
  EXPECT_DOUBLE_EQ(segment_segment_distance(o, x, 3.0 * x, 5.0 * x), 2.0);
  EXPECT_DOUBLE_EQ(segment_segment_distance(o, o, z, z), 1.0);
  EXPECT_DOUBLE_EQ(segment_segment_distance(o, o, z - x, z + x), 1.0);
  EXPECT_DOUBLE_EQ(segment_segment_distance(z - x, z + x, o, o), 1.0);
}

TEST(SegmentTriangleDistance, IsTheSmallestOfItsPoints) {
  test::RandomPoints random(6);
  for (int k = 0; k < 500; ++k) {
    const Corners t = {random.in_cube(1.0), random.in_cube(1.0), random.in_cube(1.0)};
    const Vec3 a = random.in_cube(1.5), b = random.in_cube(1.5);
    double sampled = kInfinity;
    constexpr int kSamples = 500;
    for (int j = 0; j <= kSamples; ++j) {
      const Vec3 p = a + (b - a) * j / kSamples;
      sampled = std::min(sampled, (p - nearest_on_triangle(p, t).point).norm());
    }
    const double found = segment_triangle_distance(a, b, t);
    EXPECT_LE(found, sampled + 1e-14);
    EXPECT_GE(found, sampled - (b - a).norm() / kSamples);
  }
  EXPECT_NEAR(segment_triangle_distance(Vec3(0.8, 0.5, -1.0), Vec3(0.8, 0.5, 2.0), kTriangle), 0.0,
              1e-15);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/measure/mouth.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace retiarius {
namespace {

std::vector<Vec3> regular(int corners, double radius) {
  std::vector<Vec3> p;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * kPi * k / corners;
    p.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return p;
}

TEST(Mouth, OfAHexagon) {
  const std::vector<Vec3> p = regular(6, 10.0);
  EXPECT_NEAR(projected_area(p, Vec3::UnitZ()), 150.0 * std::sqrt(3.0), 1e-10);
  EXPECT_NEAR(area_vector(p).norm(), 150.0 * std::sqrt(3.0), 1e-10);
  EXPECT_NEAR(width(p), 20.0, 1e-12);
}

TEST(Mouth, ProjectionShrinksWithTheCosineAndForgetsTheSense) {
  const std::vector<Vec3> p = regular(4, 1.0);
  const Vec3 tilted(0.0, std::sin(1.0), std::cos(1.0));
  EXPECT_NEAR(projected_area(p, tilted), 2.0 * std::cos(1.0), 1e-14);
  EXPECT_NEAR(projected_area(p, -tilted), 2.0 * std::cos(1.0), 1e-14);
  EXPECT_NEAR(projected_area(p, Vec3::UnitX()), 0.0, 1e-15);
}

TEST(Mouth, VectorAreaDoesNotDependOnTheOrigin) {
  std::vector<Vec3> p = {{0, 0, 0}, {2, 0, 1}, {2, 1, -1}, {0, 3, 2}};
  const Vec3 here = area_vector(p);
  // 1/2 sum x_i x x_(i+1), taken literally.
  Vec3 literal = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) literal += 0.5 * p[i].cross(p[(i + 1) % 4]);
  EXPECT_NEAR((here - literal).norm(), 0.0, 1e-14);
  for (Vec3& x : p) x += Vec3(1e6, -2e6, 3e6);
  EXPECT_NEAR((area_vector(p) - here).norm(), 0.0, 1e-8);
}

TEST(Mouth, CrossedMouthCancels) {
  const std::vector<Vec3> eight = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_NEAR(projected_area(eight, Vec3::UnitZ()), 0.0, 1e-15);
  EXPECT_NEAR(width(eight), std::sqrt(2.0), 1e-15);
}

TEST(Mouth, ThatIsNoPolygonHasNoArea) {
  EXPECT_EQ(area_vector({}).norm(), 0.0);
  EXPECT_EQ(area_vector({{1, 2, 3}, {4, 5, 6}}).norm(), 0.0);
  EXPECT_EQ(width({}), 0.0);
  EXPECT_EQ(width({{1, 2, 3}}), 0.0);
}

TEST(Mouth, PolygonTakesNodesInOrder) {
  const std::vector<Vec3> p = polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {2, 0});
  ASSERT_EQ(p.size(), 2U);
  EXPECT_EQ(p[0].x(), 2.0);
  EXPECT_EQ(p[1].x(), 0.0);
}

}  // namespace
}  // namespace retiarius

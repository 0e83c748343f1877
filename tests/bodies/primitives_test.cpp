#include "retiarius/bodies/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/bodies/random_points.hpp"

namespace retiarius {
namespace {

using test::RandomPoints;

// A shape with an independent statement of which points it holds.
struct Case {
  std::string name;
  std::shared_ptr<const Shape> shape;
  std::function<bool(const Vec3&)> holds;
};

std::vector<Case> cases() {
  const auto r = [](const Vec3& p) { return std::hypot(p.x(), p.y()); };
  return {
      {"sphere", make_sphere(0.8), [](const Vec3& p) { return p.norm() <= 0.8; }},
      {"box", make_box(Vec3(1.0, 2.0, 0.6)),
       [](const Vec3& p) {
         return std::abs(p.x()) <= 0.5 && std::abs(p.y()) <= 1.0 && std::abs(p.z()) <= 0.3;
       }},
      {"cylinder", make_cylinder(0.7, 1.6),
       [r](const Vec3& p) { return r(p) <= 0.7 && std::abs(p.z()) <= 0.8; }},
      {"capsule", make_capsule(0.5, 1.2),
       [](const Vec3& p) {
         const Vec3 cap(0.0, 0.0, std::clamp(p.z(), -0.6, 0.6));
         return (p - cap).norm() <= 0.5;
       }},
      {"cone", make_cone(0.9, 1.6),
       [r](const Vec3& p) {
         return p.z() >= -0.4 && p.z() <= 1.2 && r(p) <= 0.9 * (1.2 - p.z()) / 1.6;
       }},
      {"plane", make_plane(), [](const Vec3& p) { return p.z() <= 0.0; }},
  };
}

class Primitive : public testing::TestWithParam<Case> {};

// No point nearer than the distance is on the other side of the surface, and the nearest point,
// which lies at exactly that distance, has both sides next to it.
TEST_P(Primitive, DistanceIsThatOfTheNearestChangeOfSide) {
  const auto& [name, shape, holds] = GetParam();
  const Vec3 deep(0.0, 0.0, -0.1);  // inside every shape
  RandomPoints random(7);
  for (int k = 0; k < 400; ++k) {
    const Vec3 p = random.in_cube(1.8);
    const SurfacePoint s = shape->nearest(p);
    ASSERT_EQ(s.distance < 0.0, holds(p)) << p.transpose();
    EXPECT_NEAR((p - s.point).norm(), std::abs(s.distance), 1e-13);
    EXPECT_NEAR(s.normal.norm(), 1.0, 1e-14);
    EXPECT_LT((s.point + s.distance * s.normal - p).norm(), 1e-13);
    EXPECT_TRUE(holds(s.point + 1e-9 * (deep - s.point))) << p.transpose();
    EXPECT_FALSE(holds(s.point + 1e-9 * s.normal)) << p.transpose();
    for (int j = 0; j < 100; ++j) {
      const Vec3 q = p + 0.9999 * std::abs(s.distance) * random.direction();
      ASSERT_EQ(holds(q), holds(p)) << p.transpose() << " and " << q.transpose();
    }
  }
}

TEST_P(Primitive, NormalIsTheGradientOfTheDistance) {
  const Shape& shape = *GetParam().shape;
  RandomPoints random(11);
  int smooth = 0;
  for (int k = 0; k < 400; ++k) {
    const Vec3 p = random.in_cube(1.8);
    constexpr double kStep = 1e-6;
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 d = kStep * Vec3::Unit(axis);
      gradient[axis] =
          (shape.nearest(p + d).distance - shape.nearest(p - d).distance) / (2.0 * kStep);
    }
    if ((gradient - shape.nearest(p).normal).norm() < 1e-7) ++smooth;
  }
  EXPECT_GE(smooth, 398);  // all but points within the step of a crease of the distance
}

TEST_P(Primitive, DistanceChangesNoFasterThanThePointMoves) {
  const Shape& shape = *GetParam().shape;
  RandomPoints random(13);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = random.in_cube(1.8);
    const Vec3 q = p + random.within(0.0, 1.0) * random.direction();
    EXPECT_LE(std::abs(shape.nearest(p).distance - shape.nearest(q).distance),
              (p - q).norm() + 1e-13);
  }
}

TEST_P(Primitive, SegmentDistanceIsTheSmallestOfItsPoints) {
  const Shape& shape = *GetParam().shape;
  RandomPoints random(17);
  for (int k = 0; k < 300; ++k) {
    const Vec3 a = random.in_cube(1.8);
    const Vec3 b = random.in_cube(1.8);
    const double found = shape.segment_distance(a, b);
    EXPECT_NEAR(found, shape.segment_distance(b, a), 1e-11);
    // A dense scan, then a dense scan about its smallest value.
    double low = 0.0, high = 1.0, smallest = kInfinity, at = 0.0;
    for (int pass = 0; pass < 5; ++pass) {
      constexpr int kSamples = 100;
      for (int j = 0; j <= kSamples; ++j) {
        const double t = low + (high - low) * j / kSamples;
        const double d = shape.nearest(a + t * (b - a)).distance;
        if (d < smallest) smallest = d, at = t;
      }
      const double width = 2.0 * (high - low) / kSamples;
      low = std::max(0.0, at - width);
      high = std::min(1.0, at + width);
    }
    EXPECT_LE(found, smallest + 1e-12);
    EXPECT_NEAR(found, smallest, 1e-6);
  }
}

TEST_P(Primitive, SegmentOfNoLengthIsAPoint) {
  const Shape& shape = *GetParam().shape;
  const Vec3 p(0.3, -0.2, 0.9);
  EXPECT_DOUBLE_EQ(shape.segment_distance(p, p), shape.nearest(p).distance);
}

TEST_P(Primitive, BoundingRadiusHoldsTheShapeTightly) {
  const auto& [name, shape, holds] = GetParam();
  if (name == "plane") {
    EXPECT_EQ(shape->bounding_radius(), kInfinity);
    return;
  }
  double farthest = 0.0;
  for (const Vec3& p : shape->triangles().vertices) farthest = std::max(farthest, p.norm());
  EXPECT_NEAR(shape->bounding_radius(), farthest, 1e-12);
}

TEST_P(Primitive, TrianglesLieOnTheSurfaceAndFaceOutward) {
  const Shape& shape = *GetParam().shape;
  const TriangleMesh mesh = shape.triangles();
  for (const Vec3& p : mesh.vertices) EXPECT_NEAR(shape.nearest(p).distance, 0.0, 1e-14);
  const double size = std::min(2.0 * shape.bounding_radius(), 20.0);
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[static_cast<std::size_t>(t[0])];
    const Vec3 b = mesh.vertices[static_cast<std::size_t>(t[1])];
    const Vec3 c = mesh.vertices[static_cast<std::size_t>(t[2])];
    const SurfacePoint s = shape.nearest((a + b + c) / 3.0);
    EXPECT_LE(std::abs(s.distance), 1e-3 * size);
    EXPECT_GT((b - a).cross(c - a).dot(s.normal), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Primitive, testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.name; });

TEST(Primitives, ChooseAFixedNormalWhereTheNearestPointIsNotUnique) {
  EXPECT_EQ(make_sphere(1.0)->nearest(Vec3::Zero()).normal, Vec3::UnitZ());
  EXPECT_EQ(make_box(Vec3::Ones())->nearest(Vec3::Zero()).normal, Vec3::UnitX());
  EXPECT_EQ(make_box(Vec3::Ones())->nearest(Vec3(-0.1, 0.1, 0.1)).normal, Vec3(-1.0, 0.0, 0.0));
  EXPECT_EQ(make_cylinder(1.0, 10.0)->nearest(Vec3::Zero()).normal, Vec3::UnitX());
  EXPECT_EQ(make_cylinder(1.0, 2.0)->nearest(Vec3::Zero()).normal, Vec3(0.0, 0.0, -1.0));
  EXPECT_EQ(make_capsule(1.0, 2.0)->nearest(Vec3::Zero()).normal, Vec3::UnitX());
  const auto cone = make_cone(1.0, 4.0);
  const SurfacePoint apex = cone->nearest(Vec3(0.0, 0.0, 3.0));
  EXPECT_NEAR(apex.distance, 0.0, 1e-15);
  EXPECT_NEAR(apex.normal.norm(), 1.0, 1e-15);
  EXPECT_GT(apex.normal.z(), 0.0);
  EXPECT_EQ(cone->nearest(Vec3(0.0, 0.0, 5.0)).normal, Vec3::UnitZ());
}

TEST(Primitives, HaveNormalsAtTheirCornersAndEdges) {
  const SurfacePoint corner = make_box(Vec3::Ones())->nearest(Vec3(0.5, 0.5, 0.5));
  EXPECT_EQ(corner.distance, 0.0);
  EXPECT_EQ(corner.normal, Vec3::UnitX());
  const SurfacePoint rim = make_cylinder(1.0, 2.0)->nearest(Vec3(1.0, 0.0, 1.0));
  EXPECT_EQ(rim.distance, 0.0);
  EXPECT_NEAR(rim.normal.norm(), 1.0, 1e-15);
}

TEST(Primitives, MassPropertiesAreTheTextbookOnes) {
  const SolidProperties ball = make_sphere(2.0)->solid();
  EXPECT_NEAR(ball.volume, 32.0 / 3.0 * kPi, 1e-13);
  EXPECT_NEAR(ball.inertia(0, 0) / ball.volume, 0.4 * 4.0, 1e-14);
  const SolidProperties box = make_box(Vec3(1.0, 2.0, 3.0))->solid();
  EXPECT_NEAR(box.volume, 6.0, 1e-15);
  EXPECT_NEAR(box.inertia(0, 0), 6.0 * 13.0 / 12.0, 1e-14);
  EXPECT_NEAR(box.inertia(2, 2), 6.0 * 5.0 / 12.0, 1e-14);
  const SolidProperties cylinder = make_cylinder(1.0, 3.0)->solid();
  EXPECT_NEAR(cylinder.inertia(0, 0) / cylinder.volume, 1.0, 1e-14);
  EXPECT_NEAR(cylinder.inertia(2, 2) / cylinder.volume, 0.5, 1e-14);
  const SolidProperties cone = make_cone(1.0, 2.0)->solid();
  EXPECT_NEAR(cone.volume, 2.0 * kPi / 3.0, 1e-14);
  EXPECT_NEAR(cone.inertia(0, 0) / cone.volume, 0.3, 1e-14);
  EXPECT_NEAR(cone.inertia(2, 2) / cone.volume, 0.3, 1e-14);
  EXPECT_NEAR(make_cone(3.0, 4.0)->surface_area(), kPi * 3.0 * 8.0, 1e-12);
  EXPECT_NEAR(make_capsule(1.0, 2.0)->surface_area(), 8.0 * kPi, 1e-13);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/check/checked_solid.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/base/random.hpp"
#include "retiarius/bodies/primitives.hpp"
#include "retiarius/check/least_over_time.hpp"
#include "retiarius/check/plain_distance.hpp"

namespace retiarius {
namespace {

Vec3 random_vector(std::uint64_t k, double size) {
  const auto number = [&](std::uint64_t axis) {
    return (2.0 * random_uniform(9, axis, k) - 1.0) * size;
  };
  return {number(0), number(1), number(2)};
}

BodySpec spec_of(ShapeKind kind) {
  BodySpec spec;
  spec.shape = kind;
  spec.radius = 0.4;
  spec.length = 1.0;
  spec.size = Vec3(0.5, 1.0, 0.2);
  return spec;
}

// Two sets of formulas, written apart, agree: points and segments, inside and outside.
TEST(CheckedSolid, AgreesWithTheShapes) {
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::box, ShapeKind::cylinder,
                               ShapeKind::capsule, ShapeKind::cone, ShapeKind::plane}) {
    const BodySpec spec = spec_of(kind);
    const auto solid = check::checked_solid(spec, {});
    const auto shape = build_shape(spec, ".").shape;
    if (kind == ShapeKind::plane) {
      EXPECT_EQ(solid->radius(), kInfinity);
    } else {
      EXPECT_NEAR(solid->radius(), shape->bounding_radius(), 1e-12);
    }
    for (std::uint64_t k = 0; k < 300; ++k) {
      const Vec3 a = random_vector(k, 1.0), b = random_vector(k + 1000, 1.0);
      EXPECT_NEAR(solid->distance(a, a, kInfinity), shape->nearest(a).distance, 1e-12);
      EXPECT_NEAR(solid->distance(a, b, kInfinity), shape->segment_distance(a, b), 1e-9);
    }
  }
}

TEST(CheckedSolid, OfAMeshAgreesWithItsShape) {
  const TriangleMesh mesh = make_box(Vec3(0.5, 1.0, 0.2))->triangles();
  BodySpec spec;
  spec.shape = ShapeKind::mesh;
  const auto solid = check::checked_solid(spec, mesh);
  const auto shape = make_box(Vec3(0.5, 1.0, 0.2));
  int inside = 0;
  for (std::uint64_t k = 0; k < 300; ++k) {
    const Vec3 a = random_vector(k, 0.6), b = random_vector(k + 1000, 0.6);
    const double point = solid->distance(a, a, kInfinity);
    EXPECT_NEAR(point, shape->nearest(a).distance, 1e-12);
    const double exact = shape->segment_distance(a, b);
    const double found = solid->distance(a, b, kInfinity);
    EXPECT_NEAR(found, exact, exact > 0.0 ? 1e-9 : (b - a).norm() / 64.0);
    EXPECT_EQ(found <= 0.0, exact <= 0.0);
    const auto near = solid->near(a.cwiseMin(b).array() - 0.1, a.cwiseMax(b).array() + 0.1);
    const double close = near.nothing ? kInfinity : solid->distance(near, a, b, 0.1);
    EXPECT_NEAR(std::min(close, 0.1), std::min(found, 0.1), 1e-9);
    inside += point < 0.0;
  }
  EXPECT_GT(inside, 10);
}

TEST(PlainDistance, OfSegmentsAndTrianglesAgainstFineSampling) {
  constexpr int kSteps = 40;
  for (std::uint64_t k = 0; k < 40; ++k) {
    const Vec3 a = random_vector(6 * k, 1.0), b = random_vector(6 * k + 1, 1.0);
    const check::Triangle t{random_vector(6 * k + 2, 1.0), random_vector(6 * k + 3, 1.0),
                            random_vector(6 * k + 4, 1.0)};
    double edges = kInfinity, triangle = kInfinity;
    for (int i = 0; i <= kSteps; ++i) {
      const Vec3 p = a + i / double(kSteps) * (b - a);
      for (int j = 0; j <= kSteps; ++j) {
        const Vec3 q = t[0] + j / double(kSteps) * (t[1] - t[0]);
        edges = std::min(edges, (p - q).norm());
      }
      triangle = std::min(triangle, check::point_triangle(p, t));
    }
    const double reach = 0.5 * ((b - a).norm() + (t[1] - t[0]).norm()) / kSteps;
    const double exact = check::segment_segment(a, b, t[0], t[1]);
    EXPECT_LE(exact, edges + 1e-14);
    EXPECT_GE(exact, edges - reach);
    EXPECT_LE(check::segment_triangle(a, b, t), triangle + 1e-14);
    EXPECT_GE(check::segment_triangle(a, b, t), triangle - reach);
  }
}

TEST(PlainDistance, OfAPiercingSegmentIsZero) {
  const check::Triangle t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(check::segment_triangle(Vec3(0.2, 0.2, 1), Vec3(0.3, 0.3, -1), t), 0.0);
  EXPECT_NEAR(check::segment_triangle(Vec3(0.2, 0.2, 1), Vec3(0.3, 0.3, 0.25), t), 0.25, 1e-15);
}

TEST(LeastOverTime, FindsANarrowDip) {
  // A dip of depth 0.01 and half width 0.001 at 0.7321, of slope 10.
  const auto f = [](double t) { return std::min(1.0, 0.99 + 10.0 * std::abs(t - 0.7321)); };
  const check::Least least = check::least_over_time(f, 10.0, 0.999, 1e-5);
  EXPECT_NEAR(least.value, 0.99, 1e-5);
  EXPECT_NEAR(least.time, 0.7321, 1e-5);
  EXPECT_TRUE(least.resolved);
  EXPECT_EQ(check::least_over_time(f, 10.0, 0.98, 1e-5).value, 0.98);
  EXPECT_FALSE(check::least_over_time(f, 1e9, 0.999, 1e-5).resolved);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/measure/capture_quality.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/bodies/primitives.hpp"
#include "tiny_nets.hpp"

namespace retiarius {
namespace {

std::vector<Vec3> cube(double half, const Vec3& center = Vec3::Zero()) {
  std::vector<Vec3> p;
  for (int k = 0; k < 8; ++k)
    p.push_back(center + half * Vec3((k & 1) ? 1 : -1, (k & 2) ? 1 : -1, (k & 4) ? 1 : -1));
  return p;
}

const std::vector<double> kOnes(8, 1.0);

double quality(const Body& target, const std::vector<Vec3>& nodes,
               const std::vector<double>& mass = kOnes) {
  return capture_quality(*quality_scale(target), target.initial.position, nodes, mass,
                         convex_hull(nodes));
}

TEST(CaptureQuality, IsZeroForANetThatIsTheTargetsHull) {
  const Body box = make_body(make_box(Vec3::Ones()), ShapeKind::box, Vec3(1, 2, 3));
  EXPECT_NEAR(quality(box, cube(0.5, Vec3(1, 2, 3))), 0.0, 1e-14);
}

// A cube of twice the side: V ratio 8, S ratio 4; moved by d: 0.8 d over the cube's diagonal.
TEST(CaptureQuality, OfALargerCubeBesideByHand) {
  const Body box = make_body(make_box(Vec3::Ones()), ShapeKind::box, Vec3::Zero());
  EXPECT_NEAR(quality(box, cube(1.0)), 0.1 * 7 + 0.1 * 3, 1e-13);
  EXPECT_NEAR(quality(box, cube(1.0, Vec3(0, 0.6, 0))), 1.0 + 0.8 * 0.6 / std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(quality(box, cube(0.25)), 0.1 * 7 / 8 + 0.1 * 3 / 4, 1e-13);
}

TEST(CaptureQuality, SeesTheMassesOfTheNodes) {
  const Body box = make_body(make_box(Vec3::Ones()), ShapeKind::box, Vec3::Zero());
  std::vector<double> mass(8, 1.0);
  mass[7] = 9.0;  // at (0.5, 0.5, 0.5), of 16 in all: the centre moves half way there
  EXPECT_NEAR(quality(box, cube(0.5), mass), 0.8 * 0.5 * std::sqrt(0.75) / std::sqrt(3.0), 1e-14);
}

// A flat net has no volume and two faces; the volume falls to 0 and the surface to these as a cube
// is pressed flat.
TEST(CaptureQuality, OfAFlatNetIsTheLimitOfAThinOne) {
  const Body box = make_body(make_box(Vec3::Ones()), ShapeKind::box, Vec3::Zero());
  std::vector<Vec3> thin = cube(1.5), flat = thin;
  for (Vec3& p : thin) p.z() *= 1e-7;
  for (Vec3& p : flat) p.z() = 0.0;
  EXPECT_NEAR(quality(box, flat), 0.1 + 0.1 * (18.0 - 6.0) / 6.0, 1e-13);
  EXPECT_NEAR(quality(box, flat), quality(box, thin), 1e-6);
}

TEST(CaptureQuality, FlatHullOfATiltedSquareWithPointsInside) {
  const Quat turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  std::vector<Vec3> points;
  for (double x : {0.3, 0.0, 1.0, 2.0, 1.5})
    for (double y : {0.7, 0.0, 3.0, 2.9}) points.push_back(turn * Vec3(x, y, 0) + Vec3(5, 6, 7));
  EXPECT_NEAR(flat_hull_area(points), 6.0, 1e-12);
  EXPECT_EQ(flat_hull_area({Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)}), 0.0);
  EXPECT_NEAR(flat_hull_area({Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)}), 0.0, 1e-15);
  EXPECT_EQ(flat_hull_area({}), 0.0);
}

TEST(QualityScale, IsExactForASphereAndAbsentForAPlane) {
  const auto scale = quality_scale(make_body(make_sphere(0.5), ShapeKind::sphere, Vec3::Zero()));
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->volume, kPi / 6, 1e-14);
  EXPECT_NEAR(scale->area, kPi, 1e-14);
  EXPECT_NEAR(scale->length, 1.0, 1e-14);
  EXPECT_FALSE(quality_scale(make_body(make_plane(), ShapeKind::plane, Vec3::Zero())));
}

// The satellite's panels leave air between them, which its hull counts.
TEST(QualityScale, OfAMeshIsThatOfItsHull) {
  BodySpec spec;
  spec.shape = ShapeKind::mesh;
  spec.file = "satellite.obj";
  spec.density = 100.0;
  const Body body = build_body(spec, RETIARIUS_SOURCE_DIR "/missions");
  const auto scale = quality_scale(body);
  ASSERT_TRUE(scale);
  EXPECT_GT(scale->volume, 1.1 * body.shape->solid().volume);
  EXPECT_LE(scale->length, 2.0 * body.shape->bounding_radius() * (1 + 1e-14));
}

// exp(-t) + 2 sampled each 0.01 s to t = 6: near 2 at the end.
TEST(Settling, OfADecay) {
  Settling s;
  for (int k = 0; k <= 600; ++k) s.see(0.01 * k, 2.0 + std::exp(-0.01 * k));
  ASSERT_TRUE(s.value());
  EXPECT_NEAR(*s.value(), 2.0 + (std::exp(-5.5) - std::exp(-6.0)) / 0.5, 1e-4);
  // Within 5 % of 2.0032 from exp(-t) <= 0.1033 on: t = 2.270.
  EXPECT_NEAR(*s.time(), -std::log(1.05 * *s.value() - 2.0), 0.01);
}

TEST(Settling, NeedsHalfASecondWithinTheBand) {
  Settling s;
  EXPECT_FALSE(s.value());
  for (int k = 0; k <= 49; ++k) s.see(0.01 * k, 1.0);
  EXPECT_FALSE(s.value());
  s.see(0.5, 1.0);
  ASSERT_TRUE(s.value());
  EXPECT_EQ(*s.time(), 0.0);
  s.see(0.51, 1.2);
  EXPECT_FALSE(s.value());
  EXPECT_FALSE(s.time());
  s.see(0.51, 1.0);  // the same instant again: the end of a phase
  EXPECT_TRUE(s.value());
}

TEST(Settling, LeavingTheBandOnceCounts) {
  Settling s;
  for (int k = 0; k <= 200; ++k) s.see(0.01 * k, k == 100 ? 1.06 : 1.0);
  EXPECT_NEAR(*s.time(), 1.01, 1e-12);
  EXPECT_EQ(*s.value(), 1.0);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/measure/capture.hpp"

#include <gtest/gtest.h>

#include "retiarius/bodies/primitives.hpp"
#include "tiny_nets.hpp"

namespace retiarius {
namespace {

std::vector<Vec3> cube(double half) {
  std::vector<Vec3> p;
  for (int k = 0; k < 8; ++k)
    p.emplace_back((k & 1) ? half : -half, (k & 2) ? half : -half, (k & 4) ? half : -half);
  return p;
}

Body box(const Vec3& at) { return make_body(make_box(Vec3::Ones()), ShapeKind::box, at); }

TEST(Capture, OfACubeInACube) {
  const auto inside = measure_capture(box(Vec3::Zero()), box(Vec3::Zero()).initial, cube(0.6));
  ASSERT_TRUE(inside.has_value());
  EXPECT_NEAR(inside->share, 1.0, 1e-12);
  EXPECT_TRUE(inside->center_inside);
}

// The hull's side at x = 0.6 cuts the unit cube at x = 0.8 a quarter of its length in: one cap
// and 0.3 of four sides are inside.
TEST(Capture, OfACubeHalfOutside) {
  const Body b = box(Vec3(0.8, 0, 0));
  const auto part = measure_capture(b, b.initial, cube(0.6));
  EXPECT_NEAR(part->share, (1.0 + 4.0 * 0.3) / 6.0, 1e-12);
  EXPECT_FALSE(part->center_inside);
}

// A corner of the unit cube just within the hull, and just out of it: near where no hull is made.
TEST(Capture, OfACorner) {
  const double shift = 0.6 + 0.5;
  const Body near = box(Vec3::Constant(shift - 0.1)), far = box(Vec3::Constant(shift + 0.1));
  EXPECT_NEAR(measure_capture(near, near.initial, cube(0.6))->share, 3 * 0.01 / 6.0, 1e-12);
  EXPECT_EQ(measure_capture(far, far.initial, cube(0.6))->share, 0.0);
  const Body away = box(Vec3(0, 0, -50));
  EXPECT_EQ(measure_capture(away, away.initial, cube(0.6))->share, 0.0);
}

TEST(Capture, FlatNetHoldsNothing) {
  const auto flat = measure_capture(box(Vec3::Zero()), BodyState{},
                                    {{2, 2, 0}, {-2, 2, 0}, {-2, -2, 0}, {2, -2, 0}});
  ASSERT_TRUE(flat.has_value());
  EXPECT_EQ(flat->share, 0.0);
  EXPECT_FALSE(flat->center_inside);
}

TEST(Capture, OfAPlaneIsUndefined) {
  const Body plane = make_body(make_plane(), ShapeKind::plane, Vec3::Zero());
  EXPECT_FALSE(measure_capture(plane, plane.initial, cube(1.0)).has_value());
}

}  // namespace
}  // namespace retiarius

#include "retiarius/bodies/mesh_shape.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/bodies/closed_surface.hpp"
#include "retiarius/bodies/mesh_solid.hpp"
#include "tests/bodies/random_points.hpp"
#include "tests/bodies/sample_meshes.hpp"

namespace retiarius {
namespace {

using test::RandomPoints;

struct Case {
  const char* name;
  TriangleMesh mesh;
};

TriangleMesh centred(const TriangleMesh& mesh) {
  return test::shifted(mesh, -mesh_solid(mesh).center);
}

std::vector<Case> cases() {
  const TriangleMesh hollow =
      test::joined(test::ball(1.0, 2), test::turned_inside_out(test::ball(0.6, 2)));
  return {{"ball", test::ball(1.0, 3)},
          {"ring", test::ring(1.0, 0.4, 24, 12)},
          {"angle_block", centred(test::angle_block())},
          {"two_boxes", centred(test::joined(
                            test::box(Vec3(0.5, 1.0, 0.7)),
                            test::shifted(test::box(Vec3(0.4, 0.4, 0.4)), Vec3(1.0, 0.2, 0.1))))},
          {"hollow_ball", hollow}};
}

// Slow and plain: every triangle, and the winding number for the side.
double plain_distance(const TriangleMesh& mesh, const Vec3& p) {
  double least = kInfinity, angle = 0.0;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const Corners t = test::corners_of(mesh, k);
    least = std::min(least, (p - nearest_on_triangle(p, t).point).norm());
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    angle +=
        2.0 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return angle > 2.0 * kPi ? -least : least;
}

class MeshShape : public testing::TestWithParam<Case> {
 protected:
  const TriangleMesh& mesh() const { return GetParam().mesh; }
};

TEST_P(MeshShape, DistanceEqualsThePlainOne) {
  const auto shape = make_mesh(mesh());
  RandomPoints random(21);
  int inside = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 p = random.in_cube(1.6);
    const SurfacePoint s = shape->nearest(p);
    ASSERT_NEAR(s.distance, plain_distance(mesh(), p), 1e-14) << p.transpose();
    EXPECT_NEAR(s.normal.norm(), 1.0, 1e-14);
    EXPECT_LT((s.point + s.distance * s.normal - p).norm(), 1e-13);
    if (s.distance < 0.0) ++inside;
  }
  EXPECT_GT(inside, 20);
}

TEST_P(MeshShape, NormalIsTheGradientOfTheDistance) {
  const auto shape = make_mesh(mesh());
  RandomPoints random(22);
  int smooth = 0;
  for (int k = 0; k < 500; ++k) {
    const Vec3 p = random.in_cube(1.6);
    constexpr double kStep = 1e-7;
    Vec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 d = kStep * Vec3::Unit(axis);
      gradient[axis] =
          (shape->nearest(p + d).distance - shape->nearest(p - d).distance) / (2.0 * kStep);
    }
    if ((gradient - shape->nearest(p).normal).norm() < 1e-6) ++smooth;
  }
  EXPECT_GE(smooth, 498);
}

TEST_P(MeshShape, SideIsRightNextToEveryFaceEdgeAndCorner) {
  const auto shape = make_mesh(mesh());
  for (std::size_t k = 0; k < mesh().triangles.size(); ++k) {
    const Corners t = test::corners_of(mesh(), k);
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    for (const Vec3& p : {Vec3((t[0] + t[1] + t[2]) / 3.0), Vec3((t[0] + t[1]) / 2.0), t[2]}) {
      EXPECT_NEAR(shape->nearest(p).distance, 0.0, 1e-15);
      EXPECT_NEAR(shape->nearest(p).normal.norm(), 1.0, 1e-14);
      for (const double height : {-1e-3, 1e-3}) {
        const Vec3 q = p + height * normal;
        EXPECT_NEAR(shape->nearest(q).distance, plain_distance(mesh(), q), 1e-14);
      }
    }
  }
}

// The scan knows the smallest distance within half its spacing times the slope, which is at most 1;
// a second scan about its smallest value brings that down.
TEST_P(MeshShape, SegmentDistanceIsTheSmallestOfItsPoints) {
  const auto shape = make_mesh(mesh());
  RandomPoints random(23);
  int through = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 a = random.in_cube(1.4);
    const Vec3 b = k % 2 == 0 ? random.in_cube(1.4) : Vec3(a + 0.2 * random.direction());
    const double length = (b - a).norm();
    const double found = shape->segment_distance(a, b);
    constexpr int kSamples = 2000;
    std::vector<double> scan(kSamples + 1);
    for (int j = 0; j <= kSamples; ++j) {
      scan[static_cast<std::size_t>(j)] = shape->nearest(a + (b - a) * j / kSamples).distance;
    }
    const double smallest = *std::min_element(scan.begin(), scan.end());
    EXPECT_LE(found, smallest + 1e-7 * length);
    EXPECT_GE(found, smallest - 0.5 * length / kSamples - 1e-14);
    if (smallest < 0.0 && scan[0] > 0.0) ++through;
  }
  EXPECT_GT(through, 5);
}

TEST_P(MeshShape, BoundingRadiusReachesTheFarthestVertex) {
  double farthest = 0.0;
  for (const Vec3& p : mesh().vertices) farthest = std::max(farthest, p.norm());
  EXPECT_EQ(make_mesh(mesh())->bounding_radius(), farthest);
}

TEST_P(MeshShape, IsAClosedSurface) {
  const TriangleMesh closed = closed_surface(mesh(), "");
  EXPECT_EQ(closed.triangles.size(), mesh().triangles.size());
  EXPECT_EQ(closed.triangles, mesh().triangles);  // oriented already
}

INSTANTIATE_TEST_SUITE_P(All, MeshShape, testing::ValuesIn(cases()),
                         [](const auto& tested) { return tested.param.name; });

TEST(MeshShapeOfABox, EqualsTheAnalyticBox) {
  const Vec3 size(1.0, 0.4, 1.6);
  const auto box = make_box(size);
  const auto mesh = make_mesh(test::box(size));
  RandomPoints random(31);
  for (int k = 0; k < 500; ++k) {
    const Vec3 a = random.in_cube(1.2), b = random.in_cube(1.2);
    EXPECT_NEAR(mesh->nearest(a).distance, box->nearest(a).distance, 1e-14);
    EXPECT_NEAR(mesh->segment_distance(a, b), box->segment_distance(a, b), 1e-7 * (b - a).norm());
  }
  EXPECT_NEAR(mesh->surface_area(), box->surface_area(), 1e-14);
  EXPECT_LT((mesh->solid().inertia - box->solid().inertia).norm(), 1e-14);
}

TEST(MeshShapeOfABox, MeasuresSegmentsThatLieFlatOnIt) {
  const auto mesh = make_mesh(test::box(Vec3(2.0, 2.0, 2.0)));
  EXPECT_NEAR(mesh->segment_distance(Vec3(-0.9, 0.3, 1.0), Vec3(0.8, -0.7, 1.0)), 0.0, 1e-11);
  EXPECT_NEAR(mesh->segment_distance(Vec3(-0.9, 0.3, 1.25), Vec3(0.8, -0.7, 1.25)), 0.25, 1e-15);
  EXPECT_NEAR(mesh->segment_distance(Vec3(-0.5, 0.3, 0.75), Vec3(0.5, -0.7, 0.75)), -0.25, 1e-11);
  EXPECT_NEAR(mesh->segment_distance(Vec3(-3.0, 0.0, 0.0), Vec3(3.0, 0.0, 0.0)), -1.0, 1e-6);
  EXPECT_NEAR(mesh->segment_distance(Vec3(0, 0, 0.5), Vec3(0, 0, 0.5)), -0.5, 1e-15);
}

TEST(MeshShapeOfABox, SurvivesPointsThatAreNotFinite) {
  const auto mesh = make_mesh(test::box(Vec3(2.0, 2.0, 2.0)));
  EXPECT_FALSE(std::isfinite(mesh->nearest(Vec3(kInfinity, 0.0, 0.0)).distance));
  EXPECT_FALSE(std::isfinite(mesh->nearest(Vec3(0.0, std::nan(""), 0.0)).distance));
}

}  // namespace
}  // namespace retiarius

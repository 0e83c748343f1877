#include "retiarius/contact/collision_mesh.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/contact/around_revolved.hpp"

namespace retiarius {
namespace {

Body make_body(ShapeKind kind, double radius, double length) {
  BodySpec spec;
  spec.shape = kind;
  spec.radius = radius;
  spec.length = length;
  spec.size = Vec3(1, 2, 3);
  spec.motion = BodyMotion::fixed;
  return build_body(spec, ".");
}

TEST(CollisionMesh, OfASphereIsOnePoint) {
  const CollisionMesh mesh = body_collision_mesh(make_body(ShapeKind::sphere, 0.7, 0), 1e-3);
  ASSERT_EQ(mesh.points.size(), 1u);
  EXPECT_EQ(mesh.points[0], Vec3::Zero());
  EXPECT_EQ(mesh.point_radius[0], 0.7);
  EXPECT_EQ(mesh.bounding_radius, 0.7);
  EXPECT_EQ(mesh.corners, std::vector<Index>{0});
  EXPECT_TRUE(mesh.edges.empty() && mesh.triangles.empty());
}

TEST(CollisionMesh, OfACapsuleIsOneEdge) {
  const CollisionMesh mesh = body_collision_mesh(make_body(ShapeKind::capsule, 0.25, 3.0), 1e-3);
  ASSERT_EQ(mesh.edges.size(), 1u);
  EXPECT_NEAR(mesh.edge_radius[0], 0.25, 1e-15);
  EXPECT_NEAR(mesh.edge_length[0], 3.0, 1e-14);
  EXPECT_NEAR(mesh.points[1].z(), 1.5, 1e-14);
  EXPECT_NEAR(mesh.bounding_radius, 1.75, 1e-14);
}

// Diagonals of faces are flat and left out.
TEST(CollisionMesh, OfABoxHasTwelveEdges) {
  const CollisionMesh mesh = body_collision_mesh(make_body(ShapeKind::box, 0, 0), 1e-3);
  EXPECT_EQ(mesh.points.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.corners.size(), 8u);
  ASSERT_EQ(mesh.edges.size(), 12u);
  double sum = 0.0;
  for (const double length : mesh.edge_length) sum += length;
  EXPECT_NEAR(sum, 4.0 * (1.0 + 2.0 + 3.0), 1e-12);
}

TEST(CollisionMesh, OfAPlaneIsAHalfSpace) {
  const CollisionMesh mesh = body_collision_mesh(make_body(ShapeKind::plane, 0, 0), 1e-3);
  EXPECT_TRUE(mesh.half_space);
  EXPECT_EQ(mesh.bounding_radius, kInfinity);
}

// The prism holds the cylinder and leaves at most the chord error between them.
TEST(CollisionMesh, StandsCloselyAroundCylindersAndCones) {
  for (const ShapeKind kind : {ShapeKind::cylinder, ShapeKind::cone}) {
    for (const double chord : {1e-2, 1e-3, 1e-4}) {
      const Body body = make_body(kind, 1.5, 4.0);
      const TriangleMesh around = around_revolved(body, chord);
      double farthest = 0.0;
      for (const Vec3& p : around.vertices)
        farthest = std::max(farthest, body.shape->nearest(p).distance);
      EXPECT_LE(farthest, chord * (1.0 + 1e-9));
      EXPECT_GT(farthest, 0.3 * chord);
      // Faces lie outside or touch: sampled at many places.
      for (const auto& t : around.triangles) {
        const Vec3 &a = around.vertices[t[0]], &b = around.vertices[t[1]],
                   &c = around.vertices[t[2]];
        for (int i = 0; i <= 8; ++i) {
          for (int j = 0; j + i <= 8; ++j) {
            const Vec3 p = (a * i + b * j + c * (8 - i - j)) / 8.0;
            if (p.head<2>().norm() < 1.4) continue;  // the ends' inner parts lie on the ends
            ASSERT_GE(body.shape->nearest(p).distance, -1e-12);
          }
        }
        const Vec3 normal = (b - a).cross(c - a);
        EXPECT_GT(normal.dot((a + b + c) / 3.0), 0.0);  // seen from the mass centre outward
      }
    }
  }
}

TEST(CollisionMesh, OfACylinderHasNoEdgesAcrossItsEnds) {
  const CollisionMesh mesh = body_collision_mesh(make_body(ShapeKind::cylinder, 1.0, 2.0), 1e-2);
  const std::size_t sectors = (mesh.points.size() - 2) / 2;
  EXPECT_EQ(mesh.edges.size(), 3 * sectors);    // two rims and the lines along
  EXPECT_EQ(mesh.corners.size(), 2 * sectors);  // without the centres of the ends
}

// An L-shaped bar: its inner edge is concave.
TEST(CollisionMesh, LeavesOutConcaveEdges) {
  const Vec3 profile[] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  TriangleMesh bar;
  for (const double z : {0.0, 1.0})
    for (const Vec3& p : profile) bar.vertices.push_back(p + Vec3(0, 0, z));
  for (Index k = 0; k < 6; ++k) {
    const Index next = (k + 1) % 6;
    bar.triangles.push_back({k, next, next + 6});
    bar.triangles.push_back({k, next + 6, k + 6});
  }
  for (const auto& t : {std::array<Index, 3>{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    bar.triangles.push_back({t[0], t[2], t[1]});
    bar.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  }
  const CollisionMesh mesh = surface_collision_mesh(bar);
  EXPECT_EQ(mesh.edges.size(), 17u);  // of 18
  for (const auto& [a, b] : mesh.edges) EXPECT_FALSE(a == 3 && b == 9);
  EXPECT_EQ(mesh.corners.size(), 12u);
}

TEST(CollisionMesh, ChordErrorFollowsThreadAndBody) {
  const Body stage = make_body(ShapeKind::cylinder, 3.0, 8.0);  // bounding radius 5
  EXPECT_DOUBLE_EQ(usual_chord_error(stage, 1e-3), 0.25e-3);
  EXPECT_DOUBLE_EQ(usual_chord_error(stage, 1e-9), 5e-6);
  EXPECT_DOUBLE_EQ(usual_chord_error(stage, 1.0), 5e-3);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/bodies/closed_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/mesh_solid.hpp"
#include "tests/bodies/sample_meshes.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

void refused(const TriangleMesh& mesh, const std::string& text) {
  EXPECT_THAT([&] { closed_surface(mesh, "part.stl"); },
              ThrowsMessage<InputError>(HasSubstr("part.stl: " + text)));
}

TriangleMesh cube() { return test::box(Vec3::Ones()); }

// Every triangle with corners of its own, as STL has it.
TriangleMesh loosened(const TriangleMesh& mesh) {
  TriangleMesh loose;
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto first = static_cast<Index>(loose.vertices.size());
    for (const Vec3& p : test::corners_of(mesh, k)) loose.vertices.push_back(p);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  return loose;
}

TEST(ClosedSurface, SewsLooseTriangles) {
  TriangleMesh loose = loosened(test::ball(1.0, 3));
  for (std::size_t k = 0; k < loose.vertices.size(); ++k) {
    loose.vertices[k] *= 1.0 + 1e-11 * static_cast<double>(k % 7);
  }
  const TriangleMesh sewn = closed_surface(loose, "");
  EXPECT_EQ(sewn.vertices.size(), test::ball(1.0, 3).vertices.size());
  EXPECT_GT(mesh_solid(sewn).volume, 4.0);
}

TEST(ClosedSurface, TurnsTrianglesThatFaceTheWrongWay) {
  TriangleMesh mesh = cube();
  for (const std::size_t k : {1u, 4u, 5u, 9u})
    std::swap(mesh.triangles[k][0], mesh.triangles[k][1]);
  EXPECT_NEAR(mesh_solid(closed_surface(mesh, "")).volume, 1.0, 1e-15);
  EXPECT_NEAR(mesh_solid(closed_surface(test::turned_inside_out(cube()), "")).volume, 1.0, 1e-15);
}

TEST(ClosedSurface, AllowsSeveralPartsAndCavities) {
  const TriangleMesh apart = test::shifted(cube(), Vec3(3.0, 0.0, 0.0));
  EXPECT_NEAR(mesh_solid(closed_surface(test::joined(cube(), apart), "")).volume, 2.0, 1e-14);
  const TriangleMesh mixed = test::joined(cube(), test::turned_inside_out(apart));
  EXPECT_NEAR(mesh_solid(closed_surface(mixed, "")).volume, 2.0, 1e-14);

  const TriangleMesh small = test::box(Vec3::Constant(0.5));
  const TriangleMesh hollow = test::joined(cube(), test::turned_inside_out(small));
  EXPECT_NEAR(mesh_solid(closed_surface(hollow, "")).volume, 0.875, 1e-14);
  const TriangleMesh reversed = test::turned_inside_out(hollow);
  EXPECT_NEAR(mesh_solid(closed_surface(reversed, "")).volume, 0.875, 1e-14);
  refused(test::joined(cube(), small),
          "the closed part at (-0.25, -0.25, -0.25) lies inside another but is not oriented as the "
          "wall of a cavity; remove or turn it");
}

TEST(ClosedSurface, NamesAnOpenEdge) {
  TriangleMesh mesh = cube();
  mesh.triangles.pop_back();
  refused(mesh,
          "the surface is not closed: 3 open edges, the first is (0.5, -0.5, -0.5) - (0.5, -0.5, "
          "0.5); close the holes");
}

TEST(ClosedSurface, NamesAnEdgeOfManyTriangles) {
  const TriangleMesh two = test::joined(cube(), test::shifted(cube(), Vec3(1.0, 1.0, 0.0)));
  refused(two,
          "the edge (0.5, 0.5, -0.5) - (0.5, 0.5, 0.5) belongs to 4 triangles; in a closed "
          "surface every edge belongs to two");
}

TEST(ClosedSurface, NamesAVertexWhereTheSurfaceTouchesItself) {
  const TriangleMesh two = test::joined(cube(), test::shifted(cube(), Vec3::Ones()));
  refused(two, "the surface touches itself at the vertex (0.5, 0.5, 0.5)");
}

TEST(ClosedSurface, RefusesTrianglesWithoutArea) {
  TriangleMesh mesh = cube();
  mesh.triangles.push_back({0, 0, 1});
  refused(mesh, "triangle 13 at (-0.5, -0.5, -0.5) has no area; remove it or repair the mesh");
  mesh = cube();
  mesh.vertices.emplace_back(0.0, -0.5, -0.5);  // between vertices 0 and 1
  mesh.triangles.push_back({0, 8, 1});
  refused(mesh, "triangle 13 at (-0.5, -0.5, -0.5) has no area");
}

TEST(ClosedSurface, RefusesWhatHoldsNoVolume) {
  const TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  refused(sheet, "the closed part at (0, 0, 0) encloses no volume");
  const TriangleMesh point{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}};
  refused(point, "the mesh has no extent: all its points are one");
}

// The projective plane of six vertices: closed, but with one side only.
TEST(ClosedSurface, RefusesASurfaceWithOneSide) {
  TriangleMesh plane{
      {{0, 0, 1}, {1, 0, 0}, {0.3, 1, 0.1}, {-0.8, 0.6, -0.1}, {-0.8, -0.6, 0.2}, {0.3, -1, -0.2}},
      {{0, 1, 2},
       {0, 2, 3},
       {0, 3, 4},
       {0, 4, 5},
       {0, 5, 1},
       {1, 2, 4},
       {2, 3, 5},
       {3, 4, 1},
       {4, 5, 2},
       {5, 1, 3}}};
  refused(plane, "the surface cannot be oriented (it has one side only) at");
}

}  // namespace
}  // namespace retiarius

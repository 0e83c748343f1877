#include "retiarius/bodies/mesh_solid.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/bodies/sample_meshes.hpp"

namespace retiarius {
namespace {

TEST(MeshSolid, IsExactForABoxAnywhere) {
  const Vec3 place(30.0, -20.0, 10.0);
  const TriangleMesh mesh = test::shifted(test::box(Vec3(1.0, 2.0, 3.0)), place);
  const SolidProperties found = mesh_solid(mesh);
  const SolidProperties exact = make_box(Vec3(1.0, 2.0, 3.0))->solid();
  EXPECT_NEAR(found.volume, 6.0, 1e-12);
  EXPECT_LT((found.center - place).norm(), 1e-12);
  EXPECT_LT((found.inertia - exact.inertia).norm(), 1e-11);
  EXPECT_NEAR(mesh_area(mesh), 22.0, 1e-12);
  EXPECT_NEAR(mesh_solid(test::turned_inside_out(mesh)).volume, -6.0, 1e-12);
}

// The block is two boxes: 2 x 1 at (1, 0.5) and 1 x 1 at (0.5, 1.5), 1 thick.
TEST(MeshSolid, KnowsProductsOfInertia) {
  const SolidProperties found = mesh_solid(test::angle_block());
  EXPECT_NEAR(found.volume, 3.0, 1e-13);
  EXPECT_LT((found.center - Vec3(2.5 / 3.0, 2.5 / 3.0, 0.5)).norm(), 1e-13);
  const double cx = 2.5 / 3.0;
  const double product = 2.0 * (1.0 - cx) * (0.5 - cx) + 1.0 * (0.5 - cx) * (1.5 - cx);
  EXPECT_NEAR(found.inertia(0, 1), -product, 1e-13);
  EXPECT_NEAR(found.inertia(0, 2), 0.0, 1e-13);
}

TEST(MeshSolid, ConvergesToTheBallWithTheSquareOfTheMeshWidth) {
  const SolidProperties exact = make_sphere(1.5)->solid();
  double before = 0.0;
  for (const int levels : {2, 3, 4, 5}) {
    const SolidProperties found = mesh_solid(test::ball(1.5, levels));
    const double error = std::abs(found.inertia(0, 0) / exact.inertia(0, 0) - 1.0);
    if (before > 0.0) {
      EXPECT_NEAR(std::log2(before / error), 2.0, 0.15);
    }
    before = error;
    EXPECT_NEAR(found.center.norm(), 0.0, 1e-14);
  }
  EXPECT_LT(before, 3e-3);
}

// The analytic formulas against the shapes' own triangles.
TEST(MeshSolid, AgreesWithTheAnalyticShapes) {
  for (const auto& shape : {make_sphere(0.7), make_box(Vec3(1.0, 0.5, 2.0)),
                            make_cylinder(0.5, 2.0), make_capsule(0.4, 1.5), make_cone(0.8, 1.2)}) {
    const SolidProperties exact = shape->solid();
    const SolidProperties found = mesh_solid(shape->triangles());
    EXPECT_NEAR(found.volume / exact.volume, 1.0, 4e-3);
    EXPECT_LT((found.center - exact.center).norm(), 2e-3);
    EXPECT_LT((found.inertia - exact.inertia).norm(), 8e-3 * exact.inertia.norm());
    EXPECT_NEAR(mesh_area(shape->triangles()) / shape->surface_area(), 1.0, 4e-3);
  }
}

}  // namespace
}  // namespace retiarius

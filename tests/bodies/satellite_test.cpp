// The satellite that the missions capture, as it is in the repository.
#include <gtest/gtest.h>

#include "retiarius/bodies/body.hpp"
#include "retiarius/bodies/closed_surface.hpp"
#include "retiarius/bodies/mesh_file.hpp"

namespace retiarius {
namespace {

const std::string kFolder = std::string(RETIARIUS_SOURCE_DIR) + "/missions";

TEST(Satellite, IsOneClosedManifold) {
  const TriangleMesh file = read_mesh(kFolder + "/satellite.obj");
  const TriangleMesh closed = closed_surface(file, "satellite.obj");
  EXPECT_EQ(closed.triangles, file.triangles);  // nothing to turn
  const auto vertices = static_cast<int>(closed.vertices.size());
  const auto triangles = static_cast<int>(closed.triangles.size());
  EXPECT_EQ(vertices, static_cast<int>(file.vertices.size()));  // nothing to merge
  EXPECT_EQ(vertices - triangles / 2, 2);                       // Euler: one surface without holes
}

TEST(Satellite, HasThePublishedSizeAndMass) {
  BodySpec spec;
  spec.shape = ShapeKind::mesh;
  spec.file = "satellite.obj";
  spec.mass = 130.0;
  const Body body = build_body(spec, kFolder);
  const double bus = 0.60 * 0.70 * 0.85, panel = 0.70 * 0.25 * 0.85;
  const SolidProperties solid = body.shape->solid();
  EXPECT_NEAR(solid.volume, bus + 2.0 * panel, 1e-14);
  // The panels' slabs lie 0.225 m sunward of the bus's centre.
  const Vec3 offset = build_shape(spec, kFolder).offset;
  const double center = 2.0 * panel * 0.225 / solid.volume;
  EXPECT_LT((offset - Vec3(0.0, -center, 0.0)).norm(), 1e-14);
  EXPECT_NEAR(body.shape->bounding_radius(), Vec3(1.0, 0.35 - center, 0.425).norm(), 1e-14);
  // About the long axis of the panels the moment is the smallest; all are a few kg m2.
  EXPECT_LT(body.inertia(0, 0), body.inertia(1, 1));
  EXPECT_LT(body.inertia(0, 0), body.inertia(2, 2));
  const double expected = 130.0 / solid.volume *
                          (bus * (0.60 * 0.60 + 0.70 * 0.70) / 12.0 + bus * center * center +
                           2.0 * panel *
                               ((0.70 * 0.70 + 0.25 * 0.25) / 12.0 + 0.65 * 0.65 +
                                (0.225 - center) * (0.225 - center)));
  EXPECT_NEAR(body.inertia(2, 2), expected, 1e-11);
  EXPECT_NEAR(body.inertia(0, 1), 0.0, 1e-13);
}

TEST(Satellite, HasPanelsThickEnoughForNodeContact) {
  BodySpec spec;
  spec.shape = ShapeKind::mesh;
  spec.file = "satellite.obj";
  const ShapeInBody built = build_shape(spec, kFolder);
  for (const double x : {-0.65, 0.65}) {
    const Vec3 middle = Vec3(x, 0.225, 0.0) + built.offset;
    EXPECT_NEAR(built.shape->nearest(middle).distance, -0.125, 1e-14);
  }
}

}  // namespace
}  // namespace retiarius

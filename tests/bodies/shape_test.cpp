#include "retiarius/bodies/shape.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/primitives.hpp"

namespace retiarius {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(BuildShape, GivesTheShapeAsked) {
  BodySpec spec;
  spec.radius = 0.5;
  spec.length = 2.0;
  spec.size = Vec3(1.0, 2.0, 3.0);
  const auto volume = [&](ShapeKind kind) {
    spec.shape = kind;
    return build_shape(spec, "").shape->solid().volume;
  };
  EXPECT_NEAR(volume(ShapeKind::sphere), kPi / 6.0, 1e-14);
  EXPECT_NEAR(volume(ShapeKind::box), 6.0, 1e-14);
  EXPECT_NEAR(volume(ShapeKind::cylinder), kPi / 2.0, 1e-14);
  EXPECT_NEAR(volume(ShapeKind::capsule), kPi / 2.0 + kPi / 6.0, 1e-14);
  EXPECT_NEAR(volume(ShapeKind::cone), kPi / 6.0, 1e-14);
  EXPECT_EQ(volume(ShapeKind::plane), kInfinity);
}

TEST(BuildShape, NamesTheLengthThatIsWrong) {
  BodySpec spec;
  spec.name = "debris";
  spec.radius = -1.0;
  EXPECT_THAT([&] { build_shape(spec, ""); },
              ThrowsMessage<InputError>("debris: radius is -1 m; it must be positive and finite"));
  spec.radius = 1.0;
  spec.shape = ShapeKind::cone;
  EXPECT_THAT([&] { build_shape(spec, ""); },
              ThrowsMessage<InputError>("debris: length is 0 m; it must be positive and finite"));
  spec.shape = ShapeKind::box;
  spec.size = Vec3(1.0, kInfinity, 1.0);
  EXPECT_THAT(
      [&] { build_shape(spec, ""); },
      ThrowsMessage<InputError>("debris: size[1] is inf m; it must be positive and finite"));
  spec.shape = ShapeKind::sphere;
  spec.radius = std::nan("");
  EXPECT_THAT([&] { build_shape(spec, ""); },
              ThrowsMessage<InputError>(HasSubstr("radius is nan")));
}

// An STL of a box away from its file's origin, in millimetres.
TEST(BuildShape, MovesAMeshToItsMassCentre) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "shape_mesh";
  std::filesystem::create_directories(folder);
  {
    std::ofstream file(folder / "box.obj");
    for (const Vec3& p : make_box(Vec3(1000.0, 500.0, 200.0))->triangles().vertices) {
      file << "v " << p.x() + 30.0 << " " << p.y() << " " << p.z() << "\n";
    }
    for (const auto& t : make_box(Vec3::Ones())->triangles().triangles) {
      file << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
    }
  }
  BodySpec spec;
  spec.shape = ShapeKind::mesh;
  spec.file = "box.obj";
  spec.scale = 1e-3;
  const ShapeInBody built = build_shape(spec, folder.string());
  EXPECT_LT((built.offset - Vec3(-0.03, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_NEAR(built.shape->solid().volume, 0.1, 1e-15);
  EXPECT_NEAR(built.shape->solid().center.norm(), 0.0, 1e-15);
  EXPECT_NEAR(built.shape->nearest(Vec3(1.0, 0.0, 0.0)).distance, 0.5, 1e-15);

  spec.file = (folder / "box.obj").string();  // absolute
  EXPECT_NO_THROW(build_shape(spec, "/nowhere"));
  spec.scale = 0.0;
  EXPECT_THAT([&] { build_shape(spec, ""); },
              ThrowsMessage<InputError>("target: scale is 0; it must be positive and finite"));
  spec.file.clear();
  EXPECT_THAT([&] { build_shape(spec, ""); },
              ThrowsMessage<InputError>("target: a mesh needs file, an STL or OBJ file"));
  spec.file = "gone.stl";
  spec.scale = 1.0;
  EXPECT_THAT([&] { build_shape(spec, folder.string()); },
              ThrowsMessage<InputError>(HasSubstr("gone.stl: no such mesh file")));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace retiarius

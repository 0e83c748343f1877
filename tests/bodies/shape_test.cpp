#include "retiarius/bodies/shape.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"

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

}  // namespace
}  // namespace retiarius

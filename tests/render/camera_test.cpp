#include "retiarius/render/camera.hpp"

#include <gmock/gmock.h>

#include "retiarius/base/error.hpp"
#include "retiarius/render/annotation.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius::render {
namespace {

using ::testing::HasSubstr;

std::vector<Vec3> cube() {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k)
    points.emplace_back(k & 1 ? 3.0 : 1.0, k & 2 ? 5.0 : -5.0, k & 4 ? 2.0 : 0.0);
  return points;
}

TEST(Camera, HoldsAllPointsAndFillsTheAreaInOneDirection) {
  const Area area{50.0, 20.0, 400.0, 300.0};
  for (View view : {View::iso, View::front, View::side, View::top}) {
    const Camera camera(view, cube(), area);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Vec3& x : cube()) {
      const Place p = camera.place(x);
      left = std::min(left, p.x), right = std::max(right, p.x);
      top = std::min(top, p.y), bottom = std::max(bottom, p.y);
    }
    EXPECT_GE(left, area.x - 1e-9);
    EXPECT_LE(right, area.x + area.width + 1e-9);
    EXPECT_GE(top, area.y - 1e-9);
    EXPECT_LE(bottom, area.y + area.height + 1e-9);
    EXPECT_NEAR(std::max((right - left) / area.width, (bottom - top) / area.height), 1.0, 1e-9);
    EXPECT_NEAR(left + right, 2 * area.x + area.width, 1e-6);
  }
}

TEST(Camera, LooksFromWhereTheViewSays) {
  const Area area{0.0, 0.0, 100.0, 100.0};
  const auto place = [&](View view, const Vec3& x) { return Camera(view, cube(), area).place(x); };
  const Vec3 o(2.0, 0.0, 1.0);
  EXPECT_GT(place(View::front, o + Vec3::UnitX()).x, place(View::front, o).x);
  EXPECT_LT(place(View::front, o + Vec3::UnitZ()).y, place(View::front, o).y);
  EXPECT_GT(place(View::front, o + Vec3::UnitY()).depth, place(View::front, o).depth);
  EXPECT_GT(place(View::side, o + Vec3::UnitY()).x, place(View::side, o).x);
  EXPECT_LT(place(View::side, o + Vec3::UnitX()).depth, place(View::side, o).depth);
  EXPECT_LT(place(View::top, o + Vec3::UnitY()).y, place(View::top, o).y);
  EXPECT_LT(place(View::top, o + Vec3::UnitZ()).depth, place(View::top, o).depth);
  EXPECT_LT(place(View::iso, o + Vec3::UnitZ()).y, place(View::iso, o).y);
}

TEST(Camera, ScaleIsUnitsAMetreAcrossTheAxis) {
  const Camera camera(View::front, cube(), {0.0, 0.0, 640.0, 480.0});
  const Vec3 x(2.0, -4.0, 0.5);
  const double step = camera.place(x + Vec3(0.01, 0, 0)).x - camera.place(x).x;
  EXPECT_NEAR(step, 0.01 * camera.place(x).scale, 1e-9);
  EXPECT_NEAR(camera.place(Vec3(2.0, 0.0, 1.0)).scale, camera.middle_scale(), 1e-9);
}

TEST(Camera, TakesPointsThatAreAllInOnePlace) {
  const Camera camera(View::iso, {Vec3(1, 2, 3), Vec3(1, 2, 3)}, {0.0, 0.0, 100.0, 80.0});
  EXPECT_NEAR(camera.place(Vec3(1, 2, 3)).x, 50.0, 1e-6);
  EXPECT_NEAR(camera.place(Vec3(1, 2, 3)).y, 40.0, 1e-6);
}

TEST(Camera, NamesTheViewsWhereThereIsNone) {
  EXPECT_EQ(view_named("side"), View::side);
  EXPECT_THAT(testing::error_text<InputError>([] { view_named("back"); }),
              HasSubstr("there is no view back; there are iso, front, side, top"));
}

TEST(Annotation, RoundsLengthsDownAndWritesThemWithUnits) {
  EXPECT_DOUBLE_EQ(round_length(9.9), 5.0);
  EXPECT_DOUBLE_EQ(round_length(5.0), 5.0);
  EXPECT_DOUBLE_EQ(round_length(0.31), 0.2);
  EXPECT_DOUBLE_EQ(round_length(0.19), 0.1);
  EXPECT_EQ(length_text(2.0), "2 m");
  EXPECT_EQ(length_text(0.5), "50 cm");
  EXPECT_EQ(length_text(0.005), "5 mm");
  EXPECT_EQ(length_text(2000.0), "2 km");
}

}  // namespace
}  // namespace retiarius::render

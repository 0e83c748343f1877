#include "retiarius/render/colour.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace retiarius::render {
namespace {

// Relative luminance, after WCAG 2.
double luminance(const Colour& c) {
  const auto linear = [](double x) {
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

TEST(Colours, TheScaleDarkensSteadily) {
  for (int k = 0; k < 63; ++k)
    EXPECT_GT(luminance(scale_colour(k / 63.0)), luminance(scale_colour((k + 1) / 63.0))) << k;
  EXPECT_LT(luminance(scale_colour(1.0)), 0.1 * luminance(scale_colour(0.0)));
  EXPECT_EQ(scale_colour(-1.0).red, scale_colour(0.0).red);
  EXPECT_EQ(scale_colour(7.0).red, scale_colour(1.0).red);
}

TEST(Colours, OklchGivesGreysWithoutChromaAndPrimariesOfTheDisplay) {
  const Colour grey = oklch(0.5998708, 0.0, 0.0);
  EXPECT_NEAR(grey.red, 128.0 / 255.0, 1e-4);
  EXPECT_NEAR(grey.green, 128.0 / 255.0, 1e-4);
  EXPECT_NEAR(grey.blue, 128.0 / 255.0, 1e-4);
  const Colour red = oklch(0.627955, 0.257683, 29.2339);
  EXPECT_NEAR(red.red, 1.0, 1e-3);
  EXPECT_NEAR(red.green, 0.0, 2e-2);
  EXPECT_NEAR(red.blue, 0.0, 2e-2);
}

}  // namespace
}  // namespace retiarius::render

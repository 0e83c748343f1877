#include "retiarius/render/colour.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/base/vec.hpp"

namespace retiarius::render {

namespace {

double encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}

}  // namespace

Colour mixed(const Colour& a, const Colour& b, double t) {
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue)};
}

Colour oklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(radians(hue)), b = chroma * std::sin(radians(hue));
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.291485548 * b, 3);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s)};
}

Colour scale_colour(double t) {
  const double u = std::round(std::clamp(t, 0.0, 1.0) * 63.0) / 63.0;
  const double ends = (2.0 * u - 1.0) * (2.0 * u - 1.0);
  return oklch(0.8 - 0.5 * u, 0.084 + 0.05 * ends, 112.0 + 186.0 * u);
}

Colour contact_colour(int state) {
  if (state == 1) return {0.84, 0.37, 0.0};
  if (state == 2) return {0.0, 0.38, 0.68};
  return {0.62, 0.66, 0.71};
}

}  // namespace retiarius::render

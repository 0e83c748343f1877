// Colours of pictures: on a light ground, told apart by colour-blind readers.
#pragma once

namespace retiarius::render {

struct Colour {
  double red = 0.0, green = 0.0, blue = 0.0;  // sRGB, 0 to 1
};

inline constexpr Colour kPaper{1.0, 1.0, 1.0};
inline constexpr Colour kPaperBelow{0.925, 0.94, 0.955};  // at the foot of a picture
inline constexpr Colour kInk{0.13, 0.16, 0.2};
inline constexpr Colour kPaleInk{0.4, 0.45, 0.51};
inline constexpr Colour kThread{0.16, 0.24, 0.34};  // where threads show no quantity

// a + t (b - a).
Colour mixed(const Colour& a, const Colour& b, double t);

// From OKLCH: lightness 0 to 1, chroma, hue in degrees (Ottosson 2020, "A perceptual color space
// for image processing"). What a display cannot show is clipped.
Colour oklch(double lightness, double chroma, double hue);

// A scale from pale yellow over green and blue to dark violet. Lightness falls evenly with t (0 to
// 1), so that the order of values is seen without hue; 64 steps, which keeps pictures small.
Colour scale_colour(double t);

// 0 free, 1 slides, 2 sticks; after Okabe and Ito.
Colour contact_colour(int state);

}  // namespace retiarius::render

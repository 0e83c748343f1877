// What is written beside a drawing: length, colours, time.
#pragma once

#include <string>

#include <cairo.h>

#include "retiarius/render/camera.hpp"
#include "retiarius/render/painter.hpp"

namespace retiarius::render {

// A bar of a round length (m) as it looks at the middle of the scene, its left end at x, its line
// at y.
void draw_scale_bar(cairo_t* context, const Camera& camera, double x, double y, double longest,
                    double size);

// The colours with title, unit and values, `width` wide, its right end at x, its lowest text at y.
void draw_legend(cairo_t* context, const Look& look, double x, double y, double width, double size);

// The longest of 1, 2 and 5 times a power of ten that is not above the limit.
double round_length(double limit);

// "2 m", "50 cm", "5 mm".
std::string length_text(double metres);

// "t = 5.26 s".
std::string time_text(double time);

}  // namespace retiarius::render

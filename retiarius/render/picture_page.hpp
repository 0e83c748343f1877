// One picture with what is written on it. Only for the sources of render/.
#pragma once

#include <cairo.h>

#include "retiarius/render/annotation.hpp"
#include "retiarius/render/drawn_run.hpp"
#include "retiarius/render/painter.hpp"
#include "retiarius/render/pictures.hpp"

namespace retiarius::render {

// Where the scene goes on a page, with room for the texts above and below.
Area drawing_area(const Area& page, double size);

// How large lines and letters are in a picture of this size: see Look.
double usual_size(const PictureOptions& options);

// Time and phase, title, scale bar and legend about the scene.
void draw_page(cairo_t* context, const DrawnRun& run, const FrameData& frame, const Camera& camera,
               const PictureOptions& options, const Look& look);

}  // namespace retiarius::render

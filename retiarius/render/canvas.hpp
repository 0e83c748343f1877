// A cairo surface that becomes a file. Only for the sources of render/.
#pragma once

#include <memory>
#include <string>

#include <cairo.h>

#include "retiarius/render/camera.hpp"
#include "retiarius/render/colour.hpp"
#include "retiarius/render/pictures.hpp"

namespace retiarius::render {

// One drawing surface. Every member function throws Error with cairo's message when cairo failed.
class Canvas {
 public:
  // width and height: pixels (png), CSS pixels (svg), points (pdf).
  Canvas(Form form, double width, double height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  cairo_t* context() const { return context_; }
  void next_page();  // of a pdf

  // The whole file; nothing can be drawn any more.
  std::string finished();

  // Of a png surface: rows of width x height pixels, each blue, green, red, unused.
  std::string pixels();

 private:
  void check() const;

  Form form_;
  std::string bytes_;
  cairo_surface_t* surface_ = nullptr;
  cairo_t* context_ = nullptr;
};

void set_colour(cairo_t* context, const Colour& colour, double opacity = 1.0);

// Text with its base line at y. align: 0 starts at x, 0.5 is centred, 1 ends there. Returns its
// width.
double draw_text(cairo_t* context, const std::string& text, double x, double y, double size,
                 const Colour& colour, bool bold = false, double align = 0.0);
double text_width(cairo_t* context, const std::string& text, double size, bool bold = false);

// A light ground, a little darker towards its foot.
void draw_paper(cairo_t* context, const Area& area);

}  // namespace retiarius::render

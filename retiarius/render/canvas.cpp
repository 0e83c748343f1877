#include "retiarius/render/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius::render {

namespace {

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(Form form, double width, double height, std::string& bytes) {
  if (form == Form::svg) {
    cairo_surface_t* surface = cairo_svg_surface_create_for_stream(append, &bytes, width, height);
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    return surface;
  }
  if (form == Form::pdf) {
    cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
    // The date would make two files of the same picture differ.
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
    return surface;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                    static_cast<int>(height));
}

void choose_font(cairo_t* context, double size, bool bold) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, size);
}

}  // namespace

Canvas::Canvas(Form form, double width, double height)
    : form_(form), surface_(make_surface(form, width, height, bytes_)) {
  context_ = cairo_create(surface_);
  cairo_set_antialias(context_, CAIRO_ANTIALIAS_GOOD);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
  // Letters at their true widths, the same in every form.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(context_, options);
  cairo_font_options_destroy(options);
  check();
}

Canvas::~Canvas() {
  cairo_destroy(context_);
  cairo_surface_destroy(surface_);
}

void Canvas::check() const {
  const cairo_status_t status = cairo_status(context_);
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(fmt::format("cannot draw: {}", cairo_status_to_string(status)));
}

void Canvas::next_page() {
  cairo_show_page(context_);
  check();
}

std::string Canvas::finished() {
  check();
  cairo_status_t status = CAIRO_STATUS_SUCCESS;
  if (form_ == Form::png) {
    status = cairo_surface_write_to_png_stream(surface_, append, &bytes_);
  } else {
    cairo_surface_finish(surface_);
    status = cairo_surface_status(surface_);
  }
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(fmt::format("cannot draw: {}", cairo_status_to_string(status)));
  // cairo numbers its surfaces through the life of the process; the picture must not depend on it.
  const std::size_t name = form_ == Form::svg ? bytes_.find("<g id=\"surface") : std::string::npos;
  if (name != std::string::npos) {
    const std::size_t begin = name + 7;
    bytes_.replace(begin, bytes_.find('"', begin) - begin, "picture");
  }
  return std::move(bytes_);
}

std::string Canvas::pixels() {
  check();
  cairo_surface_flush(surface_);
  const auto width = static_cast<std::size_t>(cairo_image_surface_get_width(surface_));
  const auto height = static_cast<std::size_t>(cairo_image_surface_get_height(surface_));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface_));
  const unsigned char* data = cairo_image_surface_get_data(surface_);
  std::string rows;
  rows.reserve(4 * width * height);
  for (std::size_t r = 0; r < height; ++r)
    rows.append(reinterpret_cast<const char*>(data) + r * stride, 4 * width);
  return rows;
}

void set_colour(cairo_t* context, const Colour& c, double opacity) {
  cairo_set_source_rgba(context, c.red, c.green, c.blue, opacity);
}

double text_width(cairo_t* context, const std::string& text, double size, bool bold) {
  choose_font(context, size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  return extents.x_advance;
}

double draw_text(cairo_t* context, const std::string& text, double x, double y, double size,
                 const Colour& colour, bool bold, double align) {
  const double width = text_width(context, text, size, bold);
  set_colour(context, colour);
  cairo_move_to(context, x - align * width, y);
  cairo_show_text(context, text.c_str());
  return width;
}

void draw_paper(cairo_t* context, const Area& area) {
  cairo_pattern_t* ground = cairo_pattern_create_linear(0.0, area.y, 0.0, area.y + area.height);
  cairo_pattern_add_color_stop_rgb(ground, 0.35, kPaper.red, kPaper.green, kPaper.blue);
  cairo_pattern_add_color_stop_rgb(ground, 1.0, kPaperBelow.red, kPaperBelow.green,
                                   kPaperBelow.blue);
  cairo_set_source(context, ground);
  cairo_rectangle(context, area.x, area.y, area.width, area.height);
  cairo_fill(context);
  cairo_pattern_destroy(ground);
}

}  // namespace retiarius::render

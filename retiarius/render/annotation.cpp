#include "retiarius/render/annotation.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/render/canvas.hpp"

namespace retiarius::render {

namespace {

void draw_contact_legend(cairo_t* context, double x, double y, double size) {
  static const char* const kNames[] = {"free", "slides", "sticks"};
  double left = x;
  for (int k = 2; k >= 0; --k) {
    left -= text_width(context, kNames[k], 12 * size);
    draw_text(context, kNames[k], left, y, 12 * size, kInk);
    left -= 18 * size;
    set_colour(context, contact_colour(k));
    cairo_rectangle(context, left, y - 9 * size, 12 * size, 9 * size);
    cairo_fill(context);
    left -= 14 * size;
  }
  draw_text(context, quantity_title(Quantity::contact), x, y - 20 * size, 12 * size, kInk, true, 1);
}

}  // namespace

double round_length(double limit) {
  const double power = std::pow(10.0, std::floor(std::log10(limit)));
  for (double factor : {5.0, 2.0})
    if (factor * power <= limit) return factor * power;
  return power;
}

std::string length_text(double metres) {
  if (metres >= 1000.0) return fmt::format("{:g} km", metres / 1000.0);
  if (metres >= 0.9999) return fmt::format("{:g} m", metres);
  if (metres >= 0.009999) return fmt::format("{:g} cm", 100.0 * metres);
  return fmt::format("{:g} mm", 1000.0 * metres);
}

std::string time_text(double time) {
  return fmt::format("t = {:.{}f} s", time, std::abs(time) < 0.1 && time != 0.0 ? 4 : 2);
}

void draw_scale_bar(cairo_t* context, const Camera& camera, double x, double y, double longest,
                    double size) {
  const double length = round_length(longest / camera.middle_scale());
  const double width = length * camera.middle_scale(), tick = 4.0 * size;
  cairo_set_line_cap(context, CAIRO_LINE_CAP_BUTT);
  set_colour(context, kInk);
  cairo_set_line_width(context, 1.5 * size);
  cairo_move_to(context, x, y - tick);
  cairo_line_to(context, x, y);
  cairo_line_to(context, x + width, y);
  cairo_line_to(context, x + width, y - tick);
  cairo_stroke(context);
  draw_text(context, length_text(length), x + width + 8 * size, y + 1, 13 * size, kInk);
}

void draw_legend(cairo_t* context, const Look& look, double x, double y, double width,
                 double size) {
  if (look.quantity == Quantity::none) return;
  if (look.quantity == Quantity::contact) return draw_contact_legend(context, x, y, size);
  const double left = x - width, top = y - 25 * size, height = 10 * size;
  for (int k = 0; k < 64; ++k) {
    set_colour(context, scale_colour(k / 63.0));
    // Each bar reaches under the next, so that no gap shows between them.
    const double begin = left + width * k / 64.0, end = std::min(x, begin + width / 32.0);
    cairo_rectangle(context, begin, top, end - begin, height);
    cairo_fill(context);
  }
  draw_text(context, quantity_title(look.quantity), left, top - 7 * size, 12.5 * size, kInk, true);
  const double text = 12 * size;
  draw_text(context, "0", left, y, text, kInk);
  draw_text(context, fmt::format("{:g}", 0.5 * look.high), left + 0.5 * width, y, text, kInk, false,
            0.5);
  draw_text(context, fmt::format("{:g}", look.high), x, y, text, kInk, false, 1.0);
}

}  // namespace retiarius::render

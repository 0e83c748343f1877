#include "retiarius/render/painter.hpp"

#include <algorithm>

#include "retiarius/render/canvas.hpp"

namespace retiarius::render {

namespace {

// Parts of the scene fade towards the paper with distance.
class Haze {
 public:
  explicit Haze(const Camera& camera)
      : near_(camera.middle_depth() - camera.radius()), depth_(2.0 * camera.radius()) {}
  Colour operator()(const Colour& colour, double depth) const {
    const double t = std::clamp((depth - near_) / depth_, 0.0, 1.0);
    return mixed(colour, kPaper, std::round(0.42 * t * 32.0) / 32.0);
  }

 private:
  double near_, depth_;
};

void draw_surface(cairo_t* context, const SurfacePiece& piece, double size) {
  set_colour(context, piece.colour);
  cairo_move_to(context, piece.corner[0].x, piece.corner[0].y);
  for (std::size_t k = 1; k < static_cast<std::size_t>(piece.count); ++k)
    cairo_line_to(context, piece.corner[k].x, piece.corner[k].y);
  if (piece.count == 2) {
    cairo_set_line_width(context, 1.1 * size);
    cairo_stroke(context);
    return;
  }
  // The stroke closes the hair lines that anti-aliasing leaves between neighbours.
  cairo_close_path(context);
  cairo_fill_preserve(context);
  cairo_set_line_width(context, 0.7);
  cairo_stroke(context);
}

void draw_line(cairo_t* context, const Place& from, const Place& to, double shift_x, double shift_y,
               double width, const Colour& colour) {
  set_colour(context, colour);
  cairo_set_line_width(context, width);
  cairo_move_to(context, from.x + shift_x, from.y + shift_y);
  cairo_line_to(context, to.x + shift_x, to.y + shift_y);
  cairo_stroke(context);
}

// A tube: a dark rim, the lit body, and a highlight on the lamp's side where it is wide enough.
void draw_thread(cairo_t* context, const ThreadPiece& piece, const Haze& haze) {
  const Colour base = haze(
      mixed(mixed(piece.colour, kInk, 0.45), piece.colour, std::round(16.0 * piece.light) / 16.0),
      piece.depth);
  const Colour rim = mixed(base, {0.05, 0.07, 0.12}, 0.4);
  if (piece.width < 2.4) {
    draw_line(context, piece.from, piece.to, 0, 0, piece.width, base);
    return;
  }
  draw_line(context, piece.from, piece.to, 0, 0, piece.width, rim);
  draw_line(context, piece.from, piece.to, 0, 0, 0.72 * piece.width, base);
  double x = piece.to.y - piece.from.y, y = piece.from.x - piece.to.x;
  const double length = std::hypot(x, y);
  if (length < 1e-9) return;
  const double side = (-0.55 * x - 0.9 * y < 0.0 ? -1.0 : 1.0) * 0.17 * piece.width / length;
  draw_line(context, piece.from, piece.to, side * x, side * y, 0.24 * piece.width,
            mixed(base, {1.0, 1.0, 1.0}, 0.5 * piece.light));
}

void draw_ball(cairo_t* context, const ThreadPiece& piece, const Haze& haze) {
  const double r = 0.5 * piece.width, x = piece.from.x, y = piece.from.y;
  const Colour dark = haze({0.13, 0.15, 0.19}, piece.depth);
  const Colour body = haze({0.36, 0.40, 0.46}, piece.depth);
  cairo_pattern_t* shade =
      cairo_pattern_create_radial(x - 0.35 * r, y - 0.4 * r, 0.05 * r, x, y, r);
  cairo_pattern_add_color_stop_rgb(shade, 0.0, 0.93, 0.95, 0.97);
  cairo_pattern_add_color_stop_rgb(shade, 0.45, body.red, body.green, body.blue);
  cairo_pattern_add_color_stop_rgb(shade, 1.0, dark.red, dark.green, dark.blue);
  cairo_arc(context, x, y, r, 0.0, 2.0 * kPi);
  cairo_set_source(context, shade);
  cairo_fill(context);
  cairo_pattern_destroy(shade);
}

void draw_threads(cairo_t* context, const std::vector<ThreadPiece>& pieces, bool hidden,
                  const Haze& haze) {
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  for (const ThreadPiece& piece : pieces) {
    if (piece.hidden != hidden) continue;
    if (piece.ball)
      draw_ball(context, piece, haze);
    else
      draw_thread(context, piece, haze);
  }
}

}  // namespace

void draw_scene(cairo_t* context, const DrawnRun& run, const FrameData& frame, const Camera& camera,
                const Area& area, const Look& look) {
  DepthMap depths(area);
  const std::vector<SurfacePiece> surfaces =
      surface_pieces(run, frame, camera, look.bodies, depths);
  const std::vector<ThreadPiece> threads = thread_pieces(run, frame, camera, depths, look);
  const Haze haze(camera);
  draw_threads(context, threads, true, haze);
  for (const SurfacePiece& piece : surfaces) draw_surface(context, piece, look.size);
  draw_threads(context, threads, false, haze);
}

}  // namespace retiarius::render

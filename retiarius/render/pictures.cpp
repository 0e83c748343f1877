#include "retiarius/render/pictures.hpp"

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/render/canvas.hpp"
#include "retiarius/render/picture_page.hpp"

namespace retiarius::render {

void check_size(const PictureOptions& options) {
  for (int extent : {options.width, options.height})
    if (extent < 100 || extent > 8000)
      throw InputError(
          fmt::format("a picture of {}x{} cannot be drawn: width and height must be "
                      "from 100 to 8000",
                      options.width, options.height));
}

Area drawing_area(const Area& page, double size) {
  const double margin = 26.0 * size, head = 52.0 * size, foot = 66.0 * size;
  return {page.x + margin, page.y + head, page.width - 2.0 * margin, page.height - head - foot};
}

double usual_size(const PictureOptions& options) {
  return std::min(options.width / 1200.0, options.height / 900.0) * 1.15;
}

void draw_page(cairo_t* context, const DrawnRun& run, const FrameData& frame, const Camera& camera,
               const PictureOptions& options, const Look& look) {
  const double w = options.width, h = options.height, s = look.size;
  const Area page{0.0, 0.0, w, h};
  draw_paper(context, page);
  draw_scene(context, run, frame, camera, page, look);
  const double edge = 24.0 * s;
  const double after =
      edge + draw_text(context, time_text(frame.time), edge, 36 * s, 19 * s, kInk, true);
  draw_text(context, run.phase_name(frame.phase), after + 14 * s, 36 * s, 16 * s, kPaleInk);
  draw_text(context, run.title, w - edge, 36 * s, 14 * s, kPaleInk, false, 1.0);
  draw_scale_bar(context, camera, edge, h - 24 * s, 0.2 * w, s);
  draw_legend(context, look, w - edge, h - 20 * s, 210 * s, s);
}

std::vector<std::string> render_pictures(const std::filesystem::path& folder,
                                         const std::vector<double>& times, Form form,
                                         const PictureOptions& options) {
  check_size(options);
  const DrawnRun run(folder);
  std::vector<std::size_t> frames;
  for (double time : times) frames.push_back(run.frame_at(time));
  if (frames.empty()) frames.push_back(run.times.size() - 1);
  Look look{options.colour, usual_range(options.colour, run.net, run.file), usual_size(options)};
  std::vector<std::string> files;
  std::unique_ptr<Canvas> canvas;
  for (std::size_t k : frames) {
    const FrameData frame = run.file.frame(k);
    std::vector<Vec3> points;
    look.bodies = shows_bodies(run, frame.phase);
    add_points(run, frame, look.bodies, points);
    const Area page{0.0, 0.0, double(options.width), double(options.height)};
    const Camera camera(options.view, points, drawing_area(page, look.size));
    if (!canvas) canvas = std::make_unique<Canvas>(form, page.width, page.height);
    draw_page(canvas->context(), run, frame, camera, options, look);
    if (form == Form::pdf) {
      canvas->next_page();
    } else {
      files.push_back(canvas->finished());
      canvas.reset();
    }
  }
  if (canvas) files.push_back(canvas->finished());
  return files;
}

}  // namespace retiarius::render

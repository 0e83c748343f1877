#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/render/canvas.hpp"
#include "retiarius/render/picture_page.hpp"

namespace retiarius::render {

namespace {

struct Panel {
  std::size_t frame = 0;
  std::string name, when, measure;
};

// Values of the history at the row nearest to a time.
class History {
 public:
  explicit History(const RunFile& file)
      : time_(file.history("time")),
        area_(file.history("mouth_area")),
        tension_(file.history("peak_tension")),
        contacts_(file.history("contacts")) {}

  bool empty() const { return time_.empty(); }

  std::string mouth(double time) const {
    return fmt::format("mouth {:.3g} m\u00b2", area_[row(time)]);
  }
  std::string tension(double time) const {
    return fmt::format("peak tension {:.3g} N", tension_[row(time)]);
  }
  std::string contacts(double time) const {
    return fmt::format("{:g} nodes touch", contacts_[row(time)]);
  }

 private:
  std::size_t row(double time) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < time_.size(); ++k)
      if (std::abs(time_[k] - time) <= std::abs(time_[best] - time)) best = k;
    return best;
  }

  std::vector<double> time_, area_, tension_, contacts_;
};

std::string measure_text(const PhaseReport& phase, const char* name, const char* label) {
  for (const Measure& m : phase.measures)
    if (const double* value = m.name == name ? std::get_if<double>(&m.value) : nullptr)
      return fmt::format("{} {:.3g} {}", label, *value, m.unit);
  return "";
}

std::string key_measure(const DrawnRun& run, const History& history, Index phase, double time) {
  if (history.empty()) return "";
  const auto k = static_cast<std::size_t>(phase);
  const bool known = k < run.report.phases.size();
  const PhaseKind kind = known ? run.report.phases[k].kind : PhaseKind::free;
  if (kind == PhaseKind::fold) {
    const std::string bundle =
        measure_text(run.report.phases[k], "bundle_diameter", "bundle diameter");
    if (!bundle.empty()) return bundle;
  }
  if (kind == PhaseKind::shoot) return history.mouth(time) + ", " + history.tension(time);
  if (kind == PhaseKind::close || kind == PhaseKind::contact)
    return history.mouth(time) + ", " + history.contacts(time);
  return history.mouth(time);
}

// The first frame, and the last one of each phase.
std::vector<Panel> panels_of(const DrawnRun& run) {
  const History history(run.file);
  std::vector<Panel> panels;
  const std::vector<Index> phase = run.file.frame_phases();
  panels.push_back(
      {0, "start", time_text(run.times[0]), history.empty() ? "" : history.mouth(run.times[0])});
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    if (k + 1 < run.times.size() && phase[k + 1] == phase[k]) continue;
    if (k == 0 && run.times.size() > 1) continue;
    panels.push_back({k, run.phase_name(phase[k]), time_text(run.times[k]),
                      key_measure(run, history, phase[k], run.times[k])});
  }
  if (run.times.size() == 1) panels.erase(panels.begin());
  return panels;
}

void draw_frame(cairo_t* context, const Area& area, double size) {
  set_colour(context, {0.82, 0.85, 0.88});
  cairo_set_line_width(context, size);
  cairo_rectangle(context, area.x, area.y, area.width, area.height);
  cairo_stroke(context);
}

void draw_panel(cairo_t* context, const DrawnRun& run, const Panel& panel, int number,
                const Area& area, View view, Look look) {
  const double s = look.size, caption = 58.0 * s, pad = 16.0 * s, bar = 30.0 * s;
  const Area picture{area.x, area.y, area.width, area.height - caption};
  const Area inside{picture.x + pad, picture.y + pad, picture.width - 2 * pad,
                    picture.height - 2 * pad - bar};
  const FrameData frame = run.file.frame(panel.frame);
  std::vector<Vec3> points;
  look.bodies = shows_bodies(run, frame.phase);
  add_points(run, frame, look.bodies, points);
  const Camera camera(view, points, inside);
  cairo_save(context);
  cairo_rectangle(context, picture.x, picture.y, picture.width, picture.height);
  cairo_clip(context);
  draw_paper(context, picture);
  draw_scene(context, run, frame, camera, picture, look);
  draw_scale_bar(context, camera, picture.x + pad, picture.y + picture.height - pad,
                 0.25 * area.width, s);
  cairo_restore(context);
  draw_frame(context, picture, s);
  const double y = picture.y + picture.height + 22.0 * s;
  const std::string name = fmt::format("{}  {}", number, panel.name);
  const double width = draw_text(context, name, area.x + 1, y, 16 * s, kInk, true);
  draw_text(context, panel.when, area.x + width + 12 * s, y, 14 * s, kPaleInk);
  draw_text(context, panel.measure, area.x + 1, y + 20 * s, 14 * s, kInk);
}

}  // namespace

std::string render_storyboard(const std::filesystem::path& folder, Form form,
                              const PictureOptions& options) {
  check_size(options);
  const DrawnRun run(folder);
  const std::vector<Panel> panels = panels_of(run);
  const int count = static_cast<int>(panels.size());
  const int columns = count <= 3 ? count : count == 4 ? 2 : 3;
  const int rows = (count + columns - 1) / columns;
  const double width = options.width, s = width / 1200.0;
  const Look look{options.colour, usual_range(options.colour, run.net, run.file), s};
  const double margin = 22.0 * s, gap = 18.0 * s;
  const double head = options.colour == Quantity::none ? 54.0 * s : 70.0 * s;
  const double panel_width = (width - 2 * margin - (columns - 1) * gap) / columns;
  const double panel_height = 0.86 * panel_width + 58.0 * s;
  const double height = std::ceil(head + rows * panel_height + (rows - 1) * 6.0 * s + 10.0 * s);
  if (height > 32000.0)
    throw InputError(
        fmt::format("a storyboard of {} panels, {} wide, is too high to be drawn; "
                    "choose a smaller --size",
                    count, options.width));
  Canvas canvas(form, width, height);
  cairo_t* context = canvas.context();
  set_colour(context, kPaper);
  cairo_paint(context);
  draw_text(context, run.title, margin, 38.0 * s, 21.0 * s, kInk, true);
  draw_legend(context, look, width - margin, 54.0 * s, 210.0 * s, s);
  for (int k = 0; k < count; ++k) {
    const Area area{margin + (k % columns) * (panel_width + gap),
                    head + (k / columns) * (panel_height + 6.0 * s), panel_width, panel_height};
    draw_panel(context, run, panels[static_cast<std::size_t>(k)], k + 1, area, options.view, look);
  }
  return canvas.finished();
}

}  // namespace retiarius::render

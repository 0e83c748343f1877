// A spread net closes around a ball and stays shut.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace retiarius::verification {

namespace {

using Settings = std::vector<std::string>;

// The corners' path, relative to the ball: how far the mean corner is off a quarter of an ellipse
// from where it started to `radius` from the axis, `distance` behind the ball's centre. Over one.
double off_the_ellipse(const MissionRun& run, double start, double end) {
  const std::vector<Index>& corners = run.model->network.corners;
  const PhaseSpec& close = run.mission.phases[1];
  double inner = close.radius, outer = 0.0, from = 0.0, largest = 0.0;
  for (const State& s : run.frames) {
    Vec3 place = Vec3::Zero();
    double lateral = 0.0;
    for (Index c : corners) {
      place += s.x[c] / static_cast<double>(corners.size());
      lateral += std::hypot(s.x[c].x(), s.x[c].y()) / static_cast<double>(corners.size());
    }
    const double axial = place.z() - s.bodies[0].position.z();
    if (s.time <= start) {
      outer = lateral;
      from = axial;
    } else if (s.time <= end) {
      const double u = (lateral - inner) / (outer - inner);
      const double w = (axial - from) / (close.distance - from);
      largest = std::max(largest, std::abs(std::hypot(u, w) - 1.0));
    }
  }
  return largest;
}

// The last row at or before a time.
const HistoryRow& row_before(const MissionRun& run, double time) {
  const HistoryRow* last = &run.rows.front();
  for (const HistoryRow& row : run.rows)
    if (row.time <= time + 1e-9) last = &row;
  return *last;
}

void compare(Context& context, const MissionRun& run, const std::string& how) {
  const double h = run.mission.integrator.step;
  context.absolute("first contact" + how, "s", run.measure("first_contact_time"), 0.096, 1.01 * h,
                   "the ball comes 9.6 cm at 1 m/s; the first step's end at or after that",
                   "geometry");
  const double end = run.report.phases[1].end;
  context.relative(
      "mouth width where the paths end" + how, "m", row_before(run, end - 0.1).mouth_width, 0.1,
      1e-3, "corners 5 cm from the axis; the ball yields sideways by less than 0.1 mm", "geometry");
  context.absolute("distance of the corners' paths from an ellipse, relative" + how, "1",
                   off_the_ellipse(run, 0.15, end - 0.1), 0.0, 0.01,
                   "the first frame is up to a step away from the start of the path", "geometry");
  context.absolute("drift of linear momentum before and after the prescribed paths" + how, "1",
                   run.measure("linear_momentum_drift"), 0.0, 1e-12,
                   "round-off: contact is pairs of impulses", "conservation of momentum");
  context.absolute("mouth stays shut" + how, "1", run.flag("closed") ? 1.0 : 0.0, 1.0, 0.0,
                   "0.5 s at less than a tenth of the flat net's width", "the mission's purpose");
}

void run(Context& context) {
  std::vector<std::pair<std::string, Settings>> runs = {
      {"h = 10 ms, mesh 0.15 m", {"net.mesh=0.15", "integrator.step=0.01"}},
      {"h = 5 ms, mesh 0.15 m", {"net.mesh=0.15"}},
      {"h = 2.5 ms, mesh 0.15 m", {"net.mesh=0.15", "integrator.step=0.0025"}},
      {"h = 5 ms, mesh 0.1 m", {}}};
  if (context.quick()) runs = {{"mesh 0.3 m", {"net.mesh=0.3", "integrator.step=0.01"}}};
  Chart area, width;
  area.title = "Closing: mouth area";
  width.title = "Closing: mouth width";
  area.y_label = "mouth area / m2";
  width.y_label = "mouth width / m";
  for (Chart* chart : {&area, &width}) {
    chart->x_label = "time / s";
    chart->caption =
        "Hexagon net of 1.8 m side; a ball of 0.5 m radius and 200 kg comes at 1 m/s. Corners "
        "leave "
        "0.05 s after the first touch, at 1.5 s they have met behind the ball, at 1.8 s they are "
        "free.";
    chart->source = "no published values; own convergence";
  }
  for (const auto& [name, settings] : runs) {
    const MissionRun run = context.run("mission", settings);
    compare(context, run, ", " + name);
    area.curves.push_back({name, run.times(), run.column(&HistoryRow::mouth_area)});
    width.curves.push_back({name, run.times(), run.column(&HistoryRow::mouth_width)});
  }
  context.chart(area);
  context.chart(width);
}

}  // namespace

Case closing_case() {
  Case c;
  c.name = "closing";
  c.title = "Closing around a ball";
  c.group = Group::paper;
  c.figure = "Figs. 11-12";
  c.about =
      "A net spread to its widest meets a free ball; on the first touch its corner masses fly on "
      "quarters of ellipses to behind the ball and are released there. Compared: the touch, the "
      "paths, momentum, and that the mouth stays shut; shown: mouth area and width.";
  c.source = "geometry";
  c.guards = {};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

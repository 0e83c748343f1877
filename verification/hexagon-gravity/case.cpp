// A flat hexagon net falls into its six held corners and comes to rest.
#include "verification/framework/case.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace retiarius::verification {

namespace {

constexpr const char* kDigits = "one unit of the last printed digit";

std::vector<double> heights(const MissionRun& run) {
  std::vector<double> z;
  for (const HistoryRow& row : run.rows) z.push_back(row.probes[0].position.z());
  return z;
}

void compare_heights(Context& context, const MissionRun& run, const Table& wanted,
                     const std::string& scheme, double last) {
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    const double t = wanted["time"][k];
    if (t > last + 1e-9) break;
    context.absolute(fmt::format("height of the centre at {:.2f} s, {}", t, scheme), "m",
                     run.at(t).probes[0].position.z(), wanted["z"][k], 1e-6, kDigits);
  }
}

// Tension along a spoke and along a side of the net at rest.
Chart tension_chart(const MissionRun& rest) {
  Chart chart;
  chart.title = "Tension at rest";
  chart.x_label = "distance along the thread / m";
  chart.y_label = "tension / N";
  chart.caption =
      "Along the spoke from corner 0 through the centre, and along a side; static equilibrium.";
  chart.source = "no published values";
  const Network& net = rest.model->network;
  const auto along = [&](const Thread& thread, const std::string& name) {
    Curve curve{name, {}, {}, CurveStyle::line};
    double s = 0.0;
    for (Index k : thread.segments) {
      const Segment& e = net.segments[k];
      const double strain = (rest.last.x[e.a] - rest.last.x[e.b]).norm() / e.rest_length - 1.0;
      curve.x.push_back(s + 0.5 * e.rest_length);
      curve.y.push_back(net.materials[e.material].axial_stiffness * strain);
      s += e.rest_length;
    }
    chart.curves.push_back(curve);
  };
  const auto has = [](const Thread& t, Index node) {
    return std::find(t.nodes.begin(), t.nodes.end(), node) != t.nodes.end();
  };
  for (const Thread& t : net.threads) {
    if (has(t, net.center) && has(t, net.corners[0])) along(t, "spoke");
    if (t.perimeter && has(t, net.corners[0]) && has(t, net.corners[1])) along(t, "side");
  }
  return chart;
}

void compare_rest(Context& context) {
  const MissionRun rest = context.run("mission", {"integrator.method=static"});
  const HistoryRow& row = rest.rows.back();
  constexpr const char* kStatic = "digits printed; Newton's tolerance is 1e-8";
  context.relative("height of the centre at rest", "m", row.probes[0].position.z(), -0.43500957,
                   2e-8, kStatic);
  context.relative("largest strain at rest", "1", row.peak_strain, 0.1722447640, 1e-9, kStatic);
  context.relative("upward reaction of a corner at rest", "N", row.probes[1].force.z(), 94.247780,
                   1e-8, kStatic);
  context.relative("outward reaction of a corner at rest", "N", row.probes[1].force.x(), 97.21597,
                   1e-7, kStatic);
  context.chart(tension_chart(rest));
}

void run(Context& context) {
  const double last = context.quick() ? 1.0 : 2.0;
  const MissionRun euler = context.run("mission", {fmt::format("phase[0].until=time >= {}", last)});
  compare_heights(context, euler, context.table("euler"), "implicit Euler", last);
  const MissionRun trapezoid = context.run(
      "mission",
      {"integrator.method=newmark", "integrator.step=0.002", "phase[0].until=time >= 0.2"});
  compare_heights(context, trapezoid, context.table("trapezoid"), "trapezoid", 0.2);
  compare_rest(context);

  Chart chart;
  chart.title = "Hexagon net under gravity: height of the centre";
  chart.x_label = "time / s";
  chart.y_label = "height / m";
  for (const char* damping : {"0.1", "1", "5", "20"}) {
    const std::vector<std::string> set = {"environment.damping=" + std::string(damping),
                                          fmt::format("phase[0].until=time >= {}", last)};
    const MissionRun r = std::string(damping) == "0.1" ? euler : context.run("mission", set);
    chart.curves.push_back({fmt::format("mu = {} 1/s", damping), r.times(), heights(r)});
  }
  const Table wanted = context.table("euler");
  chart.curves.push_back(
      {"reference, mu = 0.1 1/s", wanted["time"], wanted["z"], CurveStyle::points});
  chart.caption = "Implicit Euler, h = 0.01 s, for several environmental dampings mu.";
  chart.source = "independent computation of the paper's case (its tutorial's parameters)";
  context.chart(chart);
}

}  // namespace

Case hexagon_gravity_case() {
  Case c;
  c.name = "hexagon-gravity";
  c.title = "Hexagon net under gravity";
  c.group = Group::paper;
  c.figure = "Fig. 2";
  c.about =
      "A flat hexagon net (side 1 m, mesh 0.2 m, 4 segments a piece, E 1 MPa, rho 1000 kg/m3, r0 "
      "1 cm, stretching only) falls under 50 m/s2 into its six held corners. Compared: the height "
      "of its centre while it swings, and shape, strain and reactions at rest.";
  c.source = "independent computation";
  c.guards = {"stretching", "gravity", "environment damping"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

// A net falls onto a ball, a box and a cylinder.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace retiarius::verification {

namespace {

using Settings = std::vector<std::string>;

struct Ground {
  std::string name;
  Settings settings;
};

std::vector<Ground> grounds() {
  return {{"ball", {"target.shape=sphere", "target.radius=0.3"}},
          {"box", {"target.shape=box", "target.size=[0.4, 0.4, 0.6]"}},
          {"cylinder",
           {"target.shape=cylinder", "target.radius=0.3", "target.length=0.8",
            "target.attitude_deg=[90, 0, 0]"}}};
}

MissionRun drop(Context& context, const Ground& ground, Settings more = {}) {
  Settings all = ground.settings;
  all.push_back("target.motion=fixed");
  all.insert(all.end(), more.begin(), more.end());
  return context.run("mission", all);
}

// Weight of the threads: two families of n + 1 lines.
double weight(const MissionRun& run) {
  const NetSpec& net = run.mission.net;
  const double lines = 2.0 * (std::round(net.side / net.mesh) + 1.0);
  return 9.81 * net.thread.density * kPi * net.thread.radius * net.thread.radius * lines * net.side;
}

// The fall until the first touch, damped: g / mu (t - (1 - e^(-mu t)) / mu).
void compare_fall(Context& context, const MissionRun& run, const std::string& on) {
  const double t = 0.08, g = 9.81, mu = run.mission.environment.damping;
  const double fall = g / mu * (t - (1.0 - std::exp(-mu * t)) / mu);
  context.absolute("height of the net after 0.08 s, before it touches the " + on, "m",
                   run.at(t).probes[0].position.z(), 0.35 - fall,
                   1.05 * 0.5 * g * run.mission.integrator.step * t,
                   "implicit Euler falls g h t / 2 too far", "free fall with damping");
}

void compare_rest(Context& context, const MissionRun& run, const std::string& on) {
  Vec3 reaction = Vec3::Zero();
  for (const Touch& t : run.last.touches) reaction += t.reaction;
  const double w = weight(run);
  context.relative("sum of the " + on + "'s forces on the net at rest", "N", reaction.z(), w, 2e-3,
                   "what still moves accelerates by less than 2e-3 g", "equilibrium");
  context.absolute("sideways sum of the " + on + "'s forces over the weight", "1",
                   std::hypot(reaction.x(), reaction.y()) / w, 0.0, 2e-3, "the same",
                   "equilibrium");
}

double mean(const std::vector<Vec3>& x) {
  double sum = 0.0;
  for (const Vec3& p : x) sum += p.z();
  return sum / static_cast<double>(x.size());
}

// All threads from the side at the run's end.
Curve side_view(const MissionRun& run) {
  Curve curve{"threads", {}, {}};
  for (const Thread& t : run.model->network.threads) {
    for (Index k : t.nodes) {
      curve.x.push_back(run.last.x[k].x());
      curve.y.push_back(run.last.x[k].z());
    }
    curve.x.push_back(std::nan(""));
    curve.y.push_back(std::nan(""));
  }
  return curve;
}

Curve outline(const std::string& on) {
  Curve curve{on, {}, {}, CurveStyle::dashed};
  if (on == "box") {
    curve.x = {-0.2, 0.2, 0.2, -0.2, -0.2};
    curve.y = {-0.3, -0.3, 0.3, 0.3, -0.3};
    return curve;
  }
  for (int k = 0; k <= 72; ++k) {
    curve.x.push_back(0.3 * std::cos(k * kPi / 36.0));
    curve.y.push_back(0.3 * std::sin(k * kPi / 36.0));
  }
  return curve;
}

void draw(Context& context, const MissionRun& run, const std::string& on) {
  Chart chart;
  chart.title = "Net at rest on a " + on;
  chart.x_label = "x / m";
  chart.y_label = "z / m";
  chart.equal_axes = true;
  chart.curves = {side_view(run), outline(on)};
  chart.caption = fmt::format(
      "From the side, {:.0f} s after the drop. Square net of 1 m, mesh 0.1 m, friction 0.3; lowest "
      "part of a thread against the surface: {:.1f} mm.",
      run.last.time, 1e3 * run.measure("smallest_distance"));
  chart.source = "no published values";
  context.chart(chart);
}

std::vector<double> corner_heights(const MissionRun& run) {
  std::vector<double> z;
  for (const HistoryRow& row : run.rows) z.push_back(row.probes[1].position.z());
  return z;
}

void refine(Context& context) {
  const Ground ball = grounds().front();
  Chart chart;
  chart.title = "Net falling on a ball: height of a corner";
  chart.x_label = "time / s";
  chart.y_label = "height / m";
  chart.caption = "Two segments a piece but for the last curve, which has four.";
  chart.source = "no published values; own convergence";
  std::vector<double> z;
  const auto add = [&](const std::string& name, Settings settings) {
    settings.push_back("phase[0].until=time >= 2.0");
    const MissionRun run = drop(context, ball, settings);
    chart.curves.push_back({name, run.times(), corner_heights(run)});
    z.push_back(mean(run.last.x));
    return run.measure("smallest_distance");
  };
  add("h = 5 ms", {"integrator.step=0.005"});
  add("h = 2 ms", {});
  add("h = 1 ms", {"integrator.step=0.001"});
  const double coarse = add("h = 2 ms, coarser: 1 segment", {"net.segments=1"});
  const double fine = add("h = 2 ms, finer: 4 segments", {"net.segments=4"});
  context.chart(chart);
  context.absolute("mean height at rest on the ball, h = 2 ms against 1 ms", "m", z[1], z[2], 0.001,
                   "friction at rest holds the net where it stopped: 0.3 % of its drop of 0.34 m",
                   "own convergence");
  context.note(fmt::format(
      "Contact is sought at nodes. A straight segment of length l between two nodes dips l^2 / 8R "
      "into a ball of radius R: with one segment a piece the threads end up to {:.1f} mm below the "
      "surface (1 cm of length and 0.3 m: 4.2 mm), with four {:.1f} mm. On the box's edges a "
      "segment "
      "cuts the corner, whatever its length, by up to a third of it.",
      -1e3 * coarse, -1e3 * fine));
}

void run(Context& context) {
  for (const Ground& ground : grounds()) {
    if (context.quick() && ground.name == "box") continue;
    const MissionRun run = context.quick()
                               ? drop(context, ground, {"net.segments=1", "integrator.step=0.005"})
                               : drop(context, ground);
    compare_fall(context, run, ground.name);
    compare_rest(context, run, ground.name);
    draw(context, run, ground.name);
  }
  if (!context.quick()) refine(context);
}

}  // namespace

Case falling_on_bodies_case() {
  Case c;
  c.name = "falling-on-bodies";
  c.title = "Net falling on a ball, a box and a cylinder";
  c.group = Group::paper;
  c.figure = "Fig. 6";
  c.about =
      "A square net (side 1 m, mesh 0.1 m, E 1 MPa, r0 4 mm) falls on fixed bodies with friction "
      "0.3. Compared: the fall before the touch, and at rest the sum of the contact forces with "
      "the "
      "net's weight; shown: the net at rest, and how its motion converges.";
  c.source = "equilibrium";
  c.guards = {"gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

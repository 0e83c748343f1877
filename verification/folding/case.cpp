// Folding: threads between grips hang as catenaries; what they end as is a bundle.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius::verification {

namespace {

// The inextensible catenary: span, sag and horizontal tension over length and weight.
struct Hang {
  double span, sag, horizontal;
};
constexpr Hang kHangs[] = {{0.9, 0.19070900, 0.56009438},
                           {0.6, 0.36278219, 0.16316827},
                           {0.3, 0.45245383, 0.05004437},
                           {0.1, 0.48901212, 0.01111132}};

// u of span / L = u / sinh u, by bisection.
double catenary_parameter(double span) {
  double low = 1e-9, high = 50.0;
  for (int k = 0; k < 200; ++k) {
    const double u = 0.5 * (low + high);
    (u / std::sinh(u) > span ? low : high) = u;
  }
  return 0.5 * (low + high);
}

// The curve at shares of the span, for a length of 1.
Curve catenary_points(double span) {
  const double u = catenary_parameter(span);
  const double a = span / (2.0 * u);
  Curve curve{"catenary", {}, {}, CurveStyle::points};
  for (int k = 0; k <= 12; ++k) {
    const double x = span * (k / 12.0 - 0.5);
    curve.x.push_back(x);
    curve.y.push_back(a * (std::cosh(x / a) - std::cosh(u)));
  }
  return curve;
}

// The side of the net between corners 0 and 1, in the vertical plane of the two.
Curve hanging_side(const MissionRun& run, const std::string& name) {
  const Network& net = run.model->network;
  const std::vector<Vec3>& x = run.last.x;
  const auto has = [](const Thread& t, Index node) {
    return std::find(t.nodes.begin(), t.nodes.end(), node) != t.nodes.end();
  };
  for (const Thread& t : net.threads) {
    if (!t.perimeter || !has(t, net.corners[0]) || !has(t, net.corners[1])) continue;
    const Vec3 a = x[t.nodes.front()], b = x[t.nodes.back()];
    Curve curve{name, {}, {}};
    for (Index k : t.nodes) {
      curve.x.push_back((x[k] - 0.5 * (a + b)).dot((b - a).normalized()));
      curve.y.push_back(x[k].z() - a.z());
    }
    return curve;
  }
  throw Error("the net has no side between corners 0 and 1");
}

double sag(const Curve& curve) { return -*std::min_element(curve.y.begin(), curve.y.end()); }

MissionRun hang(Context& context, double span, int segments) {
  return context.run(
      "hang", {fmt::format("phase[0].ratio={}", span), fmt::format("net.segments={}", segments)});
}

void compare_hang(Context& context, const MissionRun& run, const Hang& wanted, const Curve& shape) {
  const std::string at = fmt::format(" at span / length {}", wanted.span);
  constexpr const char* kShape =
      "a polygon of l = 25 mm sags by l^2 / (24 a) more, a = H / w: half as much again, and 3e-5 "
      "of "
      "stretch";
  const double l = run.mission.net.mesh / run.mission.net.segments;
  const double bound = 2.0 * l * l / (24.0 * wanted.horizontal) + 1e-4;
  context.absolute("sag over length" + at, "1", sag(shape), wanted.sag, bound, kShape);
  // Three threads of weight w L end in a corner, two of them 60 degrees from the outward one.
  const NetSpec& net = run.mission.net;
  const double weight =
      9.81 * net.thread.density * kPi * net.thread.radius * net.thread.radius * net.mesh;
  const Vec3 pull = run.last.support[run.model->network.corners[0]];
  context.relative("support's vertical force" + at, "N", pull.z(), 1.5 * weight, 1e-6,
                   "equilibrium, to the tolerance of the static solution", "exact");
  context.absolute("horizontal pull of a thread over its weight" + at, "1",
                   pull.x() / (2.0 * weight), wanted.horizontal, bound, kShape);
}

void compare_order(Context& context, const Hang& wanted) {
  double error[2];
  const int count[2] = {20, 40};
  for (int k = 0; k < 2; ++k)
    error[k] = sag(hanging_side(hang(context, wanted.span, count[k]), "")) - wanted.sag;
  context.absolute(fmt::format("order of the sag's error at span / length {}", wanted.span), "1",
                   std::log2(std::abs(error[0] / error[1])), 2.0, 0.2,
                   "a polygon of second order; the thread's stretch, 1e-5 of the sag, is the rest",
                   "order of the discretisation");
}

void compare_catenaries(Context& context) {
  Chart chart;
  chart.title = "Threads that hang between grips";
  chart.x_label = "along the span / m";
  chart.y_label = "height / m";
  chart.equal_axes = true;
  Curve reference{"catenary", {}, {}, CurveStyle::points};
  for (const Hang& wanted : kHangs) {
    const MissionRun run = hang(context, wanted.span, 40);
    const Curve shape = hanging_side(run, fmt::format("span / length {}", wanted.span));
    compare_hang(context, run, wanted, shape);
    chart.curves.push_back(shape);
    const Curve points = catenary_points(wanted.span);
    reference.x.insert(reference.x.end(), points.x.begin(), points.x.end());
    reference.y.insert(reference.y.end(), points.y.begin(), points.y.end());
  }
  compare_order(context, kHangs[1]);
  chart.curves.push_back(reference);
  chart.caption =
      "One side of a net that is gripped at its knots, after the grips have been drawn together: "
      "length 1 m, r0 0.5 mm, E 1 GPa, 1390 kg/m3, 40 segments, 9.81 m/s2.";
  chart.source = "inextensible catenary";
  context.chart(chart);
}

// All threads from the side.
Curve side_view(const Network& net, const std::vector<Vec3>& x, const std::string& name) {
  Curve curve{name, {}, {}};
  for (const Thread& t : net.threads) {
    for (Index k : t.nodes) {
      curve.x.push_back(x[k].x());
      curve.y.push_back(x[k].z());
    }
    curve.x.push_back(std::nan(""));
    curve.y.push_back(std::nan(""));
  }
  return curve;
}

double height(const MissionRun& run) {
  double low = 0.0;
  for (const Vec3& x : run.last.x) low = std::min(low, x.z());
  return -low;
}

void compare_bundle(Context& context) {
  const MissionRun run = context.run("fold");
  const NetSpec& net = run.mission.net;
  const PhaseSpec& fold = run.mission.phases[0];
  double reach = 0.0;
  for (const Vec3& x : run.last.x) reach = std::max(reach, std::hypot(x.x(), x.y()));
  context.relative("radius of the bundle", "m", reach, fold.ratio * net.side, 1e-9,
                   "grips at the corners are prescribed, to round-off", "exact");
  const double apart = fold.ratio * fold.grip_spacing;
  const double loop = std::sqrt(net.mesh * net.mesh - 0.25 * apart * apart);
  context.relative("height of the bundle", "m", height(run), 2.0 * loop, 2e-3,
                   "two loops of pieces that hang straight from grip to knot; their curvature, "
                   "stretch and last motion take 1e-4",
                   "geometry: the knots between grips hang one piece below them, those of lines "
                   "without grips another");
  Chart chart;
  chart.title = "Folding a hexagon net: seen from the side";
  chart.x_label = "x / m";
  chart.y_label = "z / m";
  chart.equal_axes = true;
  const Network& network = run.model->network;
  for (std::size_t k : {std::size_t{0}, std::size_t{2}, run.frames.size() - 1})
    chart.curves.push_back(
        side_view(network, run.frames[k].x, fmt::format("{:.0f} s", run.frames[k].time)));
  chart.caption =
      "Side 2 m, mesh 0.25 m, grips 0.5 m apart, drawn together to 0.08 in 4 s; corner masses 0.25 "
      "kg.";
  chart.source = "no published values";
  context.chart(chart);
}

void refine_bundle(Context& context) {
  Chart chart;
  chart.title = "Height of the folded net";
  chart.x_label = "segments a piece";
  chart.y_label = "height of the bundle / m";
  chart.caption = "The same folding with other steps and segments.";
  chart.source = "no published values; own convergence";
  std::vector<double> finest;
  for (double h : {0.01, 0.005, 0.0025}) {
    Curve curve{fmt::format("h = {:g} ms", 1e3 * h), {}, {}};
    for (int s : {1, 2, 4}) {
      const MissionRun run = context.run(
          "fold", {fmt::format("integrator.step={}", h), fmt::format("net.segments={}", s)});
      curve.x.push_back(s);
      curve.y.push_back(height(run));
    }
    finest.push_back(curve.y.back());
    chart.curves.push_back(curve);
  }
  context.chart(chart);
  context.relative("height of the bundle, 4 segments a piece: h = 5 ms against 2.5 ms", "m",
                   finest[1], finest[2], 5e-4,
                   "the step enters through the last of the motion alone, 4e-5 from 10 to 5 ms",
                   "own convergence");
}

void run(Context& context) {
  compare_catenaries(context);
  compare_bundle(context);
  if (!context.quick()) refine_bundle(context);
}

}  // namespace

Case folding_case() {
  Case c;
  c.name = "folding";
  c.title = "Folding: hanging threads and the folded net";
  c.group = Group::paper;
  c.figure = "Figs. 7-8";
  c.about =
      "Grips at the knots of a net are drawn together under gravity. Compared: the threads' shapes "
      "and pulls with the inextensible catenary at four spans, the order of the discretisation, "
      "and "
      "the size of a folded net with what its geometry says; shown: the net while it is folded.";
  c.source = "inextensible catenary";
  c.guards = {"gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

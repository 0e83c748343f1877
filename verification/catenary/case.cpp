// Hanging cables: the catenary, the elastic catenary, and a cable under a point load.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/catenary.hpp"
#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

namespace {

State hang(const Context& context, double span, int segments, double stiffness) {
  Network net = straight_line(segments, 1.0, plain_thread(stiffness, 1.0));
  lay_on_arc(net, span);
  return equilibrium(context, net, {0, 0, -1}, {0, segments});
}

void compare_inextensible(Context& context) {
  const Table wanted = context.table("catenary");
  constexpr const char* kDigits = "one unit of the last printed digit";
  constexpr const char* kDiscrete = "strain 2e-8 of EA = 1e8 weights, against a slack of 0.01 L";
  constexpr const char* kBend =
      "h^4 of 50 segments; at a span of 0.1 L the bend's radius, 0.011 L, is shorter than a "
      "segment, and the order is not reached; strain 2e-8 against a slack of 0.01 L";
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    const double span = wanted["span"][k];
    const std::string at = fmt::format("span {} L", span);
    const Catenary own = catenary(span);
    context.absolute("closed form's own sag, " + at, "L", own.sag, wanted["sag"][k], 1e-8, kDigits);
    context.absolute("closed form's own end tension, " + at, "w L", own.tension,
                     wanted["tension"][k], 1e-7, kDigits);
    const Chain discrete = chain(100, span);
    const State s = hang(context, span, 100, 1e8);
    context.relative("sag, 100 segments, " + at, "L", -s.x[50].z(), -discrete.nodes[50].y(), 2e-6,
                     kDiscrete, "exact chain of 100 segments");
    context.relative("horizontal force, 100 segments, " + at, "w L", s.support[100].x(),
                     discrete.pull, 2e-6, kDiscrete, "exact chain of 100 segments");
    context.relative("tension at the end, 100 segments, " + at, "w L", s.support[100].norm(),
                     std::hypot(discrete.pull, 0.5), 2e-6, kDiscrete,
                     "exact chain of 100 segments");
    const State coarse = hang(context, span, 50, 1e8);
    context.relative("sag, extrapolated, " + at, "L", -extrapolated(coarse.x[25].z(), s.x[50].z()),
                     wanted["sag"][k], span < 0.2 ? 5e-5 : 5e-6, kBend);
    context.relative("tension at the end, extrapolated, " + at, "w L",
                     extrapolated(coarse.support[50].norm(), s.support[100].norm()),
                     wanted["tension"][k], 5e-6, kBend);
  }
}

// One meter between ends at different heights, stretched by up to a tenth.
void compare_elastic(Context& context) {
  const ElasticCable cable{1.2, 2.0, 20.0};
  const Eigen::Vector2d far(1.0, 0.3);
  const Eigen::Vector2d forces = end_forces(cable, far);
  double sag[3], pull[3];
  Chart chart;
  chart.title = "Elastic cable between ends of different height";
  chart.x_label = "x / m";
  chart.y_label = "height / m";
  chart.equal_axes = true;
  for (int k = 0; k < 3; ++k) {
    const int n = 20 << k;
    Network net = straight_line(n, cable.length, plain_thread(cable.stiffness, 0.2));
    lay_on_arc(net, far.x());
    net.initial.back().z() = far.y();
    const State s = equilibrium(context, net, {0, 0, -10}, {0, n});
    sag[k] = s.x[n / 2].z();
    pull[k] = s.support[n].x();
    if (k != 0) continue;
    Curve ours{"20 segments", {}, {}};
    for (const Vec3& p : s.x) {
      ours.x.push_back(p.x());
      ours.y.push_back(p.z());
    }
    chart.curves.push_back(ours);
  }
  const Eigen::Vector2d middle = cable.point(forces[0], forces[1], 0.5 * cable.length);
  constexpr const char* kIrvine = "elastic catenary (Irvine 1981)";
  context.relative("height of the middle, extrapolated", "m", extrapolated(sag[1], sag[2]),
                   middle.y(), 1e-6, "h^4 of 40 segments, 4e-7, times derivatives", kIrvine);
  context.relative("horizontal force, extrapolated", "N", extrapolated(pull[1], pull[2]), forces[0],
                   2e-6, "h^4 of 40 segments, 4e-7, times derivatives", kIrvine);
  context.absolute("order in the mesh, height of the middle", "1",
                   observed_order(sag[1] - middle.y(), sag[2] - middle.y()), 2.0, 0.02,
                   "the error's next term is of order h^2 of it", kIrvine);
  Curve exact{"elastic catenary", {}, {}, CurveStyle::points};
  for (int k = 0; k <= 12; ++k) {
    const Eigen::Vector2d p = cable.point(forces[0], forces[1], k * cable.length / 12.0);
    exact.x.push_back(p.x());
    exact.y.push_back(p.y());
  }
  chart.curves.push_back(exact);
  chart.caption = "1.2 m unstretched, 2 N/m, EA 20 N.";
  chart.source = kIrvine;
  context.chart(chart);
}

// Jayaraman & Knudson's isolated cable: E 19e6 psi, A 0.85 in2, 3.16 lb/ft, supports 1000 ft apart;
// a load of 8 kip is hung from the point that is 400 ft from the left support and, without the
// load, 29.276 m below it. The unstretched lengths follow from that.
constexpr double kFoot = 0.3048, kPound = 4.4482216;  // m, N
constexpr double kStiffness = 19e6 * 0.85 * kPound, kWeight = 3.16 * kPound / kFoot;
constexpr double kSpan = 1000.0 * kFoot, kLoad = 8000.0 * kPound;
const Eigen::Vector2d kFar(kSpan, 0.0), kLoaded(400.0 * kFoot, -29.276);

// Left and right of the load, m.
Eigen::Vector2d unstretched_lengths() {
  const auto miss = [](const Eigen::Vector2d& lengths) -> Eigen::Vector2d {
    const ElasticCable cable{lengths.sum(), kWeight, kStiffness};
    const Eigen::Vector2d forces = end_forces(cable, kFar);
    return cable.point(forces[0], forces[1], lengths[0]) - kLoaded;
  };
  return newton(miss, {126.0, 187.0});
}

// The loaded point's place; `parts` segments in the left length and three halves of that in the
// right one, which makes them nearly equal.
Vec3 loaded_point(const Context& context, const Eigen::Vector2d& lengths, int parts, double load) {
  const int right = parts * 3 / 2;
  std::vector<Vec3> points;
  for (int k = 0; k <= parts; ++k) points.push_back({lengths[0] * k / parts, 0, 0});
  for (int k = 1; k <= right; ++k) points.push_back({lengths[0] + lengths[1] * k / right, 0, 0});
  Network net = line_through(points, plain_thread(kStiffness, kWeight / 9.81));
  lay_on_arc(net, kSpan);
  net.mass[parts] += load / 9.81;
  return equilibrium(context, net, {0, 0, -9.81}, {0, parts + right}).x[parts];
}

void compare_isolated(Context& context) {
  const Eigen::Vector2d lengths = unstretched_lengths();
  const ElasticCable cable{lengths.sum(), kWeight, kStiffness};
  const Eigen::Vector2d after = end_forces(cable, kFar, kLoad, lengths[0]);
  const Eigen::Vector2d own =
      (kLoaded - cable.point(after[0], after[1], lengths[0])) / kFoot;  // ft
  constexpr const char* kPublished = "Jayaraman & Knudson 1981";
  constexpr const char* kDigits = "one unit of the last printed digit";
  context.absolute("two catenaries' own fall of the loaded point", "ft", own.y(), 18.457, 1e-3,
                   kDigits, kPublished);
  context.absolute("two catenaries' own shift of the loaded point", "ft", own.x(), 2.819, 1e-3,
                   kDigits, kPublished);
  const auto moved = [&](int parts) -> Vec3 {
    return (loaded_point(context, lengths, parts, 0.0) -
            loaded_point(context, lengths, parts, kLoad)) /
           kFoot;
  };
  const int parts = context.quick() ? 20 : 40;
  const Vec3 coarse = moved(parts), fine = moved(2 * parts);
  const double fall = extrapolated(coarse.z(), fine.z()),
               shift = extrapolated(coarse.x(), fine.x());
  constexpr const char* kOwn = "two elastic catenaries joined at the load";
  constexpr const char* kWhy = "h^4 of 50 segments or more, 2e-7, times derivatives";
  context.relative("fall of the loaded point, extrapolated", "ft", fall, own.y(), 5e-6, kWhy, kOwn);
  context.relative("shift of the loaded point, extrapolated", "ft", shift, own.x(), 5e-6, kWhy,
                   kOwn);
  context.absolute("fall of the loaded point", "ft", fall, 18.457, 1e-3, kDigits, kPublished);
  context.absolute("shift of the loaded point", "ft", shift, 2.819, 1e-3, kDigits, kPublished);
  context.note(fmt::format(
      "The isolated cable is defined here by where its loaded point hangs before the load comes, "
      "which makes it {:.3f} m and {:.3f} m long on either side. The lengths often quoted with it, "
      "125.88 m and 186.85 m, put that point 5 cm lower and let it fall by 5.631 m instead of "
      "5.626 m: the published movement belongs to the place, not to the rounded lengths.",
      lengths[0], lengths[1]));
}

Chart shape_chart(const Context& context) {
  Chart chart;
  chart.title = "Catenaries of length 1";
  chart.x_label = "x / L";
  chart.y_label = "height / L";
  chart.equal_axes = true;
  for (double span : {0.9, 0.6, 0.3}) {
    Curve ours{fmt::format("span {} L", span), {}, {}};
    for (const Vec3& p : hang(context, span, 40, 1e7).x) {
      ours.x.push_back(p.x() - 0.5 * span);
      ours.y.push_back(p.z());
    }
    Curve exact{fmt::format("catenary, {} L", span), {}, {}, CurveStyle::points};
    const Catenary c = catenary(span);
    for (int k = -10; k <= 10; ++k) {
      const double x = 0.05 * k * span;
      exact.x.push_back(x);
      exact.y.push_back(c.pull * std::cosh(x / c.pull) - c.pull - c.sag);
    }
    chart.curves.push_back(ours);
    chart.curves.push_back(exact);
  }
  chart.caption = "40 segments without bending, EA = 1e7 weights.";
  chart.source = "catenary in closed form";
  return chart;
}

void run(Context& context) {
  compare_inextensible(context);
  compare_elastic(context);
  compare_isolated(context);
  context.chart(shape_chart(context));
}

}  // namespace

Case catenary_case() {
  Case c;
  c.name = "catenary";
  c.title = "Catenary, elastic catenary and the isolated cable";
  c.group = Group::cables;
  c.about =
      "A cable without bending hangs between two supports. Compared: sag and forces with the "
      "catenary's for seven spans and with the exact chain of as many segments; an elastic cable "
      "with the elastic catenary; and the fall and shift of the loaded point of Jayaraman & "
      "Knudson's isolated cable (span 1000 ft, EA 16.15e6 lb, 3.16 lb/ft, load 8 kip).";
  c.source = "independent computation";
  c.guards = {"stretching", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

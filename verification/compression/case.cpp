// The ends of a heavy thread are brought together: Euler's elastica where it is short, the catenary
// where it is long.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/catenary.hpp"
#include "verification/framework/elastica.hpp"
#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

namespace {

constexpr double kFlexibility = 1e-6;  // EI / (EA L^2) of the heavy lines

struct Hanging {
  std::vector<Vec3> x;
  double sag = 0.0;   // L
  double pull = 0.0;  // on the ends, inwards, EI / L^2 (or w L without EI)
};

// A line of length 1 hangs from ends a span apart; it starts as an arc of circle.
Hanging hang(const Context& context, double span, int segments, const Material& material,
             double gravity) {
  Network net = straight_line(segments, 1.0, material);
  lay_on_arc(net, span);
  const State s = equilibrium(context, net, {0, 0, -gravity}, {0, segments});
  return {s.x, -s.x[segments / 2].z(), s.support[segments].x()};
}

// weight: beta = w L^3 / EI.
Hanging heavy(const Context& context, double span, double weight, int segments,
              double flexibility = kFlexibility) {
  return hang(context, span, segments, plain_thread(1.0 / flexibility, 1.0, 1.0), weight);
}

Hanging slack(const Context& context, double span, int segments) {
  return hang(context, span, segments, plain_thread(1e7, 1.0), 1.0);
}

void compare_elastica(Context& context) {
  const Table wanted = context.table("elastica");
  constexpr const char* kDigits = "one unit of the last printed digit";
  constexpr const char* kLimit =
      "strain 2e-7 of EA = 1e8 EI / L^2; h^4 of 60 segments, 1e-7, "
      "times derivatives";
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    const double slope = wanted["slope"][k], span = wanted["span"][k];
    const Elastica own = elastica(std::sin(0.5 * slope * kPi / 180.0));
    const std::string at = fmt::format("end slope {} deg", slope);
    context.absolute("closed form's own deflection, " + at, "L", own.deflection,
                     wanted["deflection"][k], 1e-8, kDigits);
    context.absolute("closed form's own load, " + at, "P_cr", own.load, wanted["load"][k], 1e-7,
                     kDigits);
    const Hanging coarse = heavy(context, span, 0.0, 60, 1e-8),
                  fine = heavy(context, span, 0.0, 120, 1e-8);
    context.relative("deflection of the weightless line, " + at, "L",
                     extrapolated(coarse.sag, fine.sag), wanted["deflection"][k], 5e-6, kLimit);
    context.relative("load of the weightless line, " + at, "P_cr",
                     -extrapolated(coarse.pull, fine.pull) / (kPi * kPi), wanted["load"][k], 2e-5,
                     kLimit);
  }
}

void compare_catenary(Context& context) {
  const Table wanted = context.table("catenary");
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    const double span = wanted["span"][k];
    const Hanging coarse = slack(context, span, 60), fine = slack(context, span, 120);
    constexpr const char* kLimit =
        "h^4 of 60 segments; at a span of 0.1 L the bend's radius, 0.011 L, is shorter than a "
        "segment, and the order is not reached; strain 2e-7 at most against a slack of 0.01 L";
    context.relative(fmt::format("sag without bending, span {} L", span), "L",
                     extrapolated(coarse.sag, fine.sag), wanted["sag"][k], span < 0.2 ? 1e-4 : 2e-5,
                     kLimit);
  }
}

void compare_heavy(Context& context) {
  const std::vector<double> weights = {1.0, 30.0, 1000.0};
  for (double span : {0.8, 0.3}) {
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const HangingLine wanted = hanging_line(span, weights[k], kFlexibility);
      const Hanging coarse = heavy(context, span, weights[k], 60),
                    fine = heavy(context, span, weights[k], 120);
      const std::string at = fmt::format("span {} L, w L^3 / EI = {:g}", span, weights[k]);
      constexpr const char* kLimit = "h^4 of 60 segments, 1e-7, times derivatives of the bend";
      context.relative("sag, " + at, "L", extrapolated(coarse.sag, fine.sag), wanted.sag, 5e-6,
                       kLimit);
      context.absolute("horizontal force, " + at, "EI / L^2", extrapolated(coarse.pull, fine.pull),
                       wanted.pull, 2e-5 * std::max(10.0, weights[k]), kLimit);
      if (k == 1)
        context.absolute("order in the mesh, sag, " + at, "1",
                         observed_order(coarse.sag - wanted.sag, fine.sag - wanted.sag), 2.0, 0.05,
                         "the error's next term is of order h^2 of it");
    }
  }
}

// At the span at which the ends are neither pulled nor pushed.
void compare_turning(Context& context) {
  for (double weight : {10.0, 100.0, 1000.0}) {
    const HangingLine wanted = free_hanging_line(weight, kFlexibility);
    const double span = wanted.span();
    const Hanging coarse = heavy(context, span, weight, 60),
                  fine = heavy(context, span, weight, 120);
    const std::string at = fmt::format("span {:.4f} L, w L^3 / EI = {:g}", span, weight);
    context.absolute("horizontal force where it turns, " + at, "w L",
                     extrapolated(coarse.pull, fine.pull) / weight, 0.0, 2e-5,
                     "h^4 of 60 segments, 1e-7, times derivatives of the bend");
    context.relative("sag where the force turns, " + at, "L", extrapolated(coarse.sag, fine.sag),
                     wanted.sag, 5e-6, "h^4 of 60 segments, 1e-7, times derivatives of the bend");
  }
}

Curve right_half_of(const std::vector<Station>& half, const std::string& name) {
  Curve curve{name, {}, {}, CurveStyle::points};
  for (std::size_t k = 0; k < half.size(); k += 50) {
    curve.x.push_back(half[k].x);
    curve.y.push_back(half[k].y - half.back().y);
  }
  return curve;
}

Chart shape_chart(const Context& context) {
  Chart chart;
  chart.title = "Ends brought together to 0.3 L: shapes";
  chart.x_label = "x / L";
  chart.y_label = "height / L";
  chart.equal_axes = true;
  const std::vector<double> weights = {1.0, 30.0, 1000.0};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    Curve ours{fmt::format("w L^3 / EI = {:g}", weights[k]), {}, {}};
    for (const Vec3& p : heavy(context, 0.3, weights[k], 100).x) {
      ours.x.push_back(p.x() - 0.15);
      ours.y.push_back(p.z());
    }
    chart.curves.push_back(ours);
  }
  chart.curves.push_back(right_half_of(hanging_line(0.3, 1.0).half, "heavy elastica, 1"));
  chart.curves.push_back(right_half_of(hanging_line(0.3, 30.0).half, "heavy elastica, 30"));
  Curve hanging{"catenary", {}, {}, CurveStyle::dashed};
  for (const Eigen::Vector2d& p : chain(1000, 0.3).nodes) {
    hanging.x.push_back(p.x() - 0.15);
    hanging.y.push_back(p.y());
  }
  chart.curves.push_back(hanging);
  chart.caption =
      "100 segments, pinned ends; from Euler's elastica (light) to the catenary (heavy).";
  chart.source = "heavy elastica by shooting; catenary";
  return chart;
}

Chart sag_chart(const Context& context) {
  Chart chart;
  chart.title = "Sag of a heavy thread against the catenary's";
  chart.x_label = "rho A g L^3 / EI / 1";
  chart.y_label = "sag / sag of the catenary";
  chart.log_x = true;
  std::vector<double> weights, marks;
  for (double power = -1.0; power < 3.51; power += context.quick() ? 0.5 : 0.125)
    weights.push_back(std::pow(10.0, power));
  for (double power = -1.0; power < 3.51; power += context.quick() ? 1.5 : 0.5)
    marks.push_back(std::pow(10.0, power));
  for (double span : {0.6, 0.3, 0.1}) {
    const double sag = catenary(span).sag;
    Curve ours{fmt::format("span {} L", span), weights, {}};
    for (double weight : weights) ours.y.push_back(heavy(context, span, weight, 60).sag / sag);
    Curve exact{fmt::format("heavy elastica, {} L", span), marks, {}, CurveStyle::points};
    for (double weight : marks) exact.y.push_back(hanging_line(span, weight).sag / sag);
    chart.curves.push_back(ours);
    chart.curves.push_back(exact);
  }
  chart.caption = "60 segments; left: Euler's elastica, right: the catenary (1).";
  chart.source = "heavy elastica by shooting; catenary";
  return chart;
}

Chart pull_chart(const Context& context) {
  Chart chart;
  chart.title = "Horizontal force as the ends come together";
  chart.x_label = "end distance / L";
  chart.y_label = "horizontal force / (rho A g L)";
  for (double weight : {10.0, 100.0, 1000.0}) {
    Curve ours{fmt::format("w L^3 / EI = {:g}", weight), {}, {}};
    for (double span = 0.05; span < 0.951; span += context.quick() ? 0.1 : 0.025) {
      ours.x.push_back(span);
      ours.y.push_back(heavy(context, span, weight, 60).pull / weight);
    }
    chart.curves.push_back(ours);
  }
  Curve turning{"no force, heavy elastica", {}, {}, CurveStyle::points};
  for (double weight : {10.0, 100.0, 1000.0}) {
    turning.x.push_back(free_hanging_line(weight).span());
    turning.y.push_back(0.0);
  }
  Curve hanging{"catenary", {}, {}, CurveStyle::dashed};
  for (double span = 0.05; span < 0.951; span += 0.025) {
    hanging.x.push_back(span);
    hanging.y.push_back(catenary(span).pull);
  }
  chart.curves.push_back(hanging);
  chart.curves.push_back(turning);
  chart.caption =
      "Positive: the thread pulls its ends together; negative: it pushes them apart. "
      "60 segments, pinned ends.";
  chart.source = "catenary; heavy elastica by shooting";
  return chart;
}

// The span at which the sag of our line has lost a share against the catenary's.
double span_of_loss(const Context& context, double weight, double loss) {
  return root(
      [&](double span) {
        return heavy(context, span, weight, 60).sag / catenary(span).sag - 1.0 + loss;
      },
      0.02, 0.7);
}

// Where catenary-guided folding fails, from our own lines.
void limit(Context& context) {
  Chart chart;
  chart.title = "Smallest spans for which the catenary guides the fold";
  chart.x_label = "rho A g L^3 / EI / 1";
  chart.y_label = "end distance / L";
  chart.log_x = chart.log_y = true;
  Curve turning{"no horizontal force, heavy elastica", {}, {}, CurveStyle::dashed};
  for (double power = 0.5; power < 4.01; power += 0.125) {
    turning.x.push_back(std::pow(10.0, power));
    turning.y.push_back(free_hanging_line(turning.x.back()).span());
  }
  Curve ours{"no horizontal force, 60 segments", {}, {}, CurveStyle::points};
  for (double power = 0.5; power < 3.01; power += context.quick() ? 1.0 : 0.25) {
    const double weight = std::pow(10.0, power), near = free_hanging_line(weight).span();
    // Linear between two spans on either side: the error is of the second order of 2 %.
    const double a = 0.98 * near, b = std::min(1.02 * near, 0.999);
    const double pa = heavy(context, a, weight, 60).pull, pb = heavy(context, b, weight, 60).pull;
    ours.x.push_back(weight);
    ours.y.push_back(a - pa * (b - a) / (pb - pa));
  }
  chart.curves = {turning, ours};
  if (!context.quick()) {
    Curve loss{"sag 5 % short of the catenary's, 60 segments", {}, {}};
    for (double power = 0.5; power < 3.01; power += 0.5) {
      loss.x.push_back(std::pow(10.0, power));
      loss.y.push_back(span_of_loss(context, loss.x.back(), 0.05));
    }
    chart.curves.push_back(loss);
  }
  chart.caption = "Below the dashed line the thread pushes its ends apart instead of pulling them.";
  chart.source = "heavy elastica by shooting";
  context.chart(chart);
}

void tell_limits(Context& context) {
  const double l = std::cbrt(7.854e-4 / (kPi * 1e-3 * 9.81));  // 1 mm, 1 GPa, 1000 kg/m3, on earth
  const double shortest = free_hanging_line(1e4).span() * std::cbrt(1e4);
  context.note(fmt::format(
      "A thread hangs or stands according to its length against l = (EI / (rho A g))^(1/3). One "
      "much "
      "longer than l pulls its ends together like a catenary until they are {:.3f} l apart, "
      "whatever "
      "its length ({:.3f} l for L = 10 l, {:.3f} l for L = 4.6 l); closer than that it pushes them "
      "apart. One shorter than about 2 l pushes almost at once and follows Euler's "
      "elastica. There folding along catenaries fails: the forces that are to hold the fold have "
      "the "
      "wrong sign, and its bends are wider than catenaries. For a thread of r0 1 mm, 1 GPa and "
      "1000 kg/m3 on earth l is {:.2f} m and the smallest span {:.2f} m.",
      shortest, free_hanging_line(1e3).span() * 10.0,
      free_hanging_line(100.0).span() * std::cbrt(100.0), l, shortest * l));
  context.note(
      "The sag tells little: it follows from the length, and between elastica and catenary differs "
      "by 12 % even with ends 0.3 L apart. The sign of the horizontal force tells at once.");
}

void run(Context& context) {
  compare_elastica(context);
  compare_catenary(context);
  compare_heavy(context);
  compare_turning(context);
  context.chart(shape_chart(context));
  context.chart(sag_chart(context));
  context.chart(pull_chart(context));
  limit(context);
  tell_limits(context);
}

}  // namespace

Case compression_case() {
  Case c;
  c.name = "compression";
  c.title = "Ends brought together: Euler's elastica against the catenary";
  c.group = Group::paper;
  c.figure = "Fig. 18";
  c.about =
      "The pinned ends of a heavy thread are brought together, for rho A g L^3 / EI from 0 to "
      "infinity. Compared: deflection and load with Euler's elastica, sag with the catenary, and "
      "between them sag and horizontal force with the heavy elastica; and the span below which the "
      "thread pushes its ends apart, so that folding along catenaries fails (the sign of the "
      "horizontal force, and 5 % of the sag).";
  c.source = "independent computation; heavy elastica by shooting";
  c.guards = {"stretching", "bending", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

// A pinned line under a load at midspan: a beam for small forces, a cable for large ones.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/elastica.hpp"
#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

namespace {

constexpr double kAxial = 1e9 * kPi * 1e-4;          // EA, N
constexpr double kBending = 1e9 * kPi * 1e-8 / 4.0;  // EI, N m2
constexpr double kFlexibility = kBending / kAxial;   // L = 1 m

double deflection(const Context& context, double force, int segments,
                  Bending kind = Bending::bounded) {
  Network net = straight_line(segments, 1.0, solid_thread(1e9, 1e3, 1e-2, kind));
  const Index middle = segments / 2;
  load_only(net, middle, force);
  return -equilibrium(context, net, {0, 0, -1}, {0, segments}).x[middle].z();
}

double beam(double force) { return force / (48.0 * kBending); }

// Two straight strings of EA: F = 4 EA u (1 - 1 / sqrt(1 + 4 u^2)).
double cable(double force) {
  return bisect(
      [&](double u) {
        return 4.0 * kAxial * u * (1.0 - 1.0 / std::sqrt(1.0 + 4.0 * u * u)) - force;
      },
      0.0, 2.0);
}

double continuum(double force) { return midpoint_deflection(force / kBending, kFlexibility); }

void compare_table(Context& context) {
  const Table wanted = context.table("load");
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    const double force = wanted["force"][k];
    context.absolute(fmt::format("deflection, 101 nodes, F = {:g} N", force), "L",
                     deflection(context, force, 100), wanted["deflection"][k], 1e-6,
                     "one unit of the last printed digit");
  }
}

void compare_asymptotes(Context& context) {
  context.relative("deflection, F = 0.01 N, by beam theory", "L", deflection(context, 0.01, 100),
                   beam(0.01), 2e-4,
                   "1/N^2 = 1e-4 of the mesh; the line's stretching takes (u / r0)^2 / 2 = 4e-6",
                   "beam theory, F L^3 / (48 EI)");
  // Bending rounds the kink off over sqrt(EI / T) on either side of it.
  const double u = cable(1e5), tension = kAxial * (std::sqrt(1.0 + 4.0 * u * u) - 1.0);
  context.relative("deflection, F = 1e5 N, by cable theory", "L", deflection(context, 1e5, 100), u,
                   2.0 * std::sqrt(kBending / tension),
                   "the kink is rounded off over sqrt(EI / T) = 0.01 L on either side",
                   "two straight elastic strings");
}

void compare_refinement(Context& context) {
  for (double force : {0.1, 10.0, 100.0}) {
    const double wanted = continuum(force);
    double u[3];
    for (int k = 0; k < 3; ++k) u[k] = deflection(context, force, 50 << k);
    context.absolute(fmt::format("order in the mesh, F = {:g} N", force), "1",
                     observed_order(u[1] - wanted, u[2] - wanted), 2.0, 0.02,
                     "the error's next term is of order h^2 of it");
    context.relative(
        fmt::format("deflection, extrapolated, F = {:g} N", force), "L", extrapolated(u[1], u[2]),
        wanted, 2e-7,
        "(h q)^4 / 100 at 100 segments with q = sqrt(T / EI), 9 / L at 100 N, is 7e-7");
  }
}

Chart chart_of(const Context& context) {
  Chart chart;
  chart.title = "Midpoint load: from beam to cable";
  chart.x_label = "force / N";
  chart.y_label = "deflection / L";
  chart.log_x = chart.log_y = true;
  Curve ours{"101 nodes", {}, {}, CurveStyle::line}, tabulated{"reference, 101 nodes", {}, {}},
      as_beam{"beam, F L^3 / (48 EI)", {}, {}, CurveStyle::dashed},
      as_cable{"cable", {}, {}, CurveStyle::dashed};
  const Table wanted = context.table("load");
  tabulated.x = wanted["force"];
  tabulated.y = wanted["deflection"];
  tabulated.style = CurveStyle::points;
  for (double power = -1.0; power < 5.01; power += context.quick() ? 0.5 : 0.125) {
    const double force = std::pow(10.0, power);
    ours.x.push_back(force);
    ours.y.push_back(deflection(context, force, 100));
    as_beam.x.push_back(force);
    as_beam.y.push_back(beam(force) < 0.5 ? beam(force) : std::nan(""));
    as_cable.x.push_back(force);
    as_cable.y.push_back(cable(force));
  }
  chart.curves = {ours, as_beam, as_cable, tabulated};
  chart.caption =
      "Both ends pinned 1 m apart, r0 1 cm, E 1 GPa; force at the middle node over six decades.";
  chart.source = "independent computation; beam and cable theory";
  return chart;
}

void run(Context& context) {
  compare_table(context);
  compare_asymptotes(context);
  compare_refinement(context);
  context.chart(chart_of(context));
  context.note(fmt::format(
      "Beam and cable theory cross at a deflection of {:.4f} L = {:.2f} r0 and {:.1f} N: a thread "
      "bent sideways by more than about its own thickness between fixed points carries by tension, "
      "and its bending stiffness only rounds its kinks.",
      std::sqrt(6.0 * kFlexibility), std::sqrt(6.0 * kFlexibility) / 0.01,
      48.0 * kBending * std::sqrt(6.0 * kFlexibility)));
}

}  // namespace

Case midpoint_load_case() {
  Case c;
  c.name = "midpoint-load";
  c.title = "Midpoint load: from beam to cable";
  c.group = Group::paper;
  c.figure = "Fig. 17";
  c.about =
      "A line pinned at both ends (L 1 m, r0 1 cm, E 1 GPa: EI 7.854 N m2, EA 314 kN) under a "
      "force at its middle from 0.1 N to 100 kN. Compared: its deflection with the discrete "
      "problem's, with beam and cable theory at the ends, and with the extensible elastica.";
  c.source = "independent computation";
  c.guards = {"stretching", "bending", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

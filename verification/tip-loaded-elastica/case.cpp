// A cantilever bent by a force at its tip that keeps its direction.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/elastica.hpp"
#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

namespace {

constexpr double kFlexibility = 1e-6;  // EI / (EA L^2): r0 = L / 500
constexpr double kDegree = kPi / 180.0;

struct Tip {
  double slope, deflection, shift;  // deg, L, L
};

// A line of L = EI = 1 whose first segment is held and begins half of itself behind the clamp.
std::vector<Vec3> shape(const Context& context, double alpha, int segments,
                        Bending kind = Bending::bounded) {
  const double h = 1.0 / (segments - 0.5);
  Network net =
      straight_line(segments, segments * h, plain_thread(1.0 / kFlexibility, 1.0, 1.0, kind));
  load_only(net, segments, alpha);
  std::vector<Vec3> x = equilibrium(context, net, {0, 0, -1}, {0, 1}).x;
  for (Vec3& p : x) p.x() -= 0.5 * h;
  return x;
}

// No moment at the tip: its slope is that of the last segment to the order of h^2, from whose
// middle it turns by alpha cos(slope) h^2 / 8.
Tip tip(const std::vector<Vec3>& x) {
  const Vec3 last = x.back() - x[x.size() - 2];
  return {std::atan2(-last.z(), last.x()) / kDegree, -x.back().z(), 1.0 - x.back().x()};
}

void compare_elastica(Context& context) {
  const Table wanted = context.table("elastica");
  constexpr const char* kDigits = "one unit of the last printed digit";
  constexpr const char* kLimit =
      "h^4 of 100 segments, 1e-8, times derivatives; axial strain 1e-6 alpha";
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    const double alpha = wanted["alpha"][k];
    const std::string at = fmt::format("alpha = {}", alpha);
    const Station own = cantilever(0.0, alpha).back();
    context.absolute("shooting's own deflection, " + at, "L", -own.y, wanted["deflection"][k], 1e-8,
                     kDigits);
    context.absolute("shooting's own slope, " + at, "deg", -own.angle / kDegree, wanted["slope"][k],
                     1e-6, kDigits);
    const Tip coarse = tip(shape(context, alpha, 50)), fine = tip(shape(context, alpha, 100));
    const double order = 2.0 * std::log2(99.5 / 49.5);
    const double bound = 1e-6 * (1.0 + alpha);
    context.absolute("deflection, extrapolated, " + at, "L",
                     extrapolated(coarse.deflection, fine.deflection, order),
                     wanted["deflection"][k], bound, kLimit);
    context.absolute("shift, extrapolated, " + at, "L",
                     extrapolated(coarse.shift, fine.shift, order), wanted["shift"][k], bound,
                     kLimit);
    context.absolute("slope of the tip, extrapolated, " + at, "deg",
                     extrapolated(coarse.slope, fine.slope, order), wanted["slope"][k],
                     bound / kDegree, kLimit);
  }
}

void compare_order(Context& context) {
  for (double alpha : {1.0, 10.0}) {
    const double wanted = -cantilever(0.0, alpha, kFlexibility).back().y;
    for (Bending kind : {Bending::bounded, Bending::tangent}) {
      const double coarse = tip(shape(context, alpha, 50, kind)).deflection - wanted;
      const double fine = tip(shape(context, alpha, 100, kind)).deflection - wanted;
      const char* name = kind == Bending::bounded ? "bounded" : "tangent";
      context.absolute(fmt::format("order in the mesh, alpha = {}, {}", alpha, name), "1",
                       observed_order(coarse, fine) / std::log2(99.5 / 49.5), 2.0, 0.01,
                       "the error's next term is of order h^2 of it");
    }
  }
}

void draw(Context& context) {
  const Table wanted = context.table("elastica");
  Chart chart;
  chart.title = "Tip-loaded cantilever: deflection and shift of the tip";
  chart.x_label = "P L^2 / EI / 1";
  chart.y_label = "displacement / L";
  Curve down{"deflection", {}, {}}, back{"shift towards the clamp", {}, {}};
  for (double alpha = 0.25; alpha < 10.01; alpha += context.quick() ? 0.75 : 0.25) {
    const Tip t = tip(shape(context, alpha, 50));
    down.x.push_back(alpha);
    down.y.push_back(t.deflection);
    back.x.push_back(alpha);
    back.y.push_back(t.shift);
  }
  chart.curves = {
      down,
      back,
      {"deflection, elliptic integrals", wanted["alpha"], wanted["deflection"], CurveStyle::points},
      {"shift, elliptic integrals", wanted["alpha"], wanted["shift"], CurveStyle::points}};
  chart.caption =
      "50 segments, bounded curvature, EA L^2 / EI = 1e6; the load keeps its direction.";
  chart.source = "Bisshopp & Drucker 1945 (independently recomputed)";
  context.chart(chart);

  Chart shapes;
  shapes.title = "Tip-loaded cantilever: shapes";
  shapes.x_label = "x / L";
  shapes.y_label = "height / L";
  shapes.equal_axes = true;
  for (double alpha : {1.0, 4.0, 10.0}) {
    Curve ours{fmt::format("alpha = {}", alpha), {}, {}},
        exact{fmt::format("elastica, {}", alpha), {}, {}};
    for (const Vec3& p : shape(context, alpha, 50)) {
      ours.x.push_back(p.x());
      ours.y.push_back(p.z());
    }
    const std::vector<Station> line = cantilever(0.0, alpha);
    for (std::size_t k = 0; k < line.size(); k += 100) {
      exact.x.push_back(line[k].x);
      exact.y.push_back(line[k].y);
    }
    exact.style = CurveStyle::points;
    shapes.curves.push_back(ours);
    shapes.curves.push_back(exact);
  }
  shapes.caption = "50 segments over the elastica from shooting.";
  shapes.source = "elastica by shooting";
  context.chart(shapes);
}

void run(Context& context) {
  compare_elastica(context);
  compare_order(context);
  draw(context);
}

}  // namespace

Case tip_loaded_elastica_case() {
  Case c;
  c.name = "tip-loaded-elastica";
  c.title = "Tip-loaded elastica";
  c.group = Group::rods;
  c.about =
      "A cantilever (L = EI = 1, EA = 1e6) bent by a force at its tip that keeps its direction, "
      "P L^2 / EI from 0.25 to 10. Compared: slope, deflection and shift of the tip, extrapolated "
      "from 50 and 100 segments, and the order in the mesh.";
  c.source = "Bisshopp & Drucker 1945 (independently recomputed)";
  c.guards = {"stretching", "bending", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

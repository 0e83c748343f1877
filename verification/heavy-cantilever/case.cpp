// A horizontal cantilever sags under its weight: linear theory, elastica, both curvatures.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/elastica.hpp"
#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

namespace {

const char* name_of(Bending kind) { return kind == Bending::bounded ? "bounded" : "tangent"; }

// Where the length of 1 m is measured from: the clamp's outer node, or the place whose direction
// and height two held nodes fix, which is the middle of the segment between them.
enum class Clamp { outer_node, middle_of_segment };

// E 1 GPa, r0 1 mm, rho 1000: beta = 4 g.
Material stiff(Bending kind) { return solid_thread(1e9, 1e3, 1e-3, kind); }

// The same but for EA = 1e5 EI / L^2, 40 times less, which keeps round-off down: EA eps against the
// weight of a node limits what a fine mesh can show.
constexpr double kFlexibility = 1e-5;
Material soft(Bending kind, double flexibility = kFlexibility) {
  const Material m = stiff(kind);
  return plain_thread(m.bending_stiffness / flexibility, m.line_density, m.bending_stiffness, kind);
}

// Deflection of the tip.
double deflection(const Context& context, double beta, int nodes, const Material& material,
                  Clamp clamp) {
  const int segments = nodes - 1;
  const double free = clamp == Clamp::outer_node ? segments : segments - 0.5;
  const Network net = straight_line(segments, segments / free, material);
  return -equilibrium(context, net, {0, 0, -0.25 * beta}, {0, 1}).x.back().z();
}

double continuum(double beta, double flexibility = 0.0) {
  return -cantilever(beta, 0.0, flexibility).back().y;
}

void compare_discrete(Context& context) {
  const Table wanted = context.table("discrete");
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    for (Bending kind : {Bending::bounded, Bending::tangent}) {
      const double beta = wanted["beta"][k];
      context.absolute(fmt::format("deflection, 50 nodes, beta = {}, {}", beta, name_of(kind)), "L",
                       deflection(context, beta, 50, stiff(kind), Clamp::outer_node),
                       wanted[name_of(kind)][k], 1e-6, "one unit of the last printed digit");
    }
  }
}

// The shooting that the continuum's values are taken from, against values of other origin.
void compare_shooting(Context& context) {
  const Table wanted = context.table("continuum");
  for (std::size_t k = 0; k < wanted.rows(); ++k) {
    const double beta = wanted["beta"][k];
    const Station tip = cantilever(beta, 0.0).back();
    constexpr const char* kDigits = "one unit of the last printed digit";
    context.absolute(fmt::format("shooting's own deflection, beta = {}", beta), "L", -tip.y,
                     wanted["deflection"][k], 1e-8, kDigits);
    context.absolute(fmt::format("shooting's own tip distance, beta = {}", beta), "L", tip.x,
                     wanted["distance"][k], 1e-8, kDigits);
  }
}

struct Refinement {
  std::vector<double> nodes, error;
  double order = 0.0, limit = 0.0;
};

Refinement refine(const Context& context, double beta, Bending kind, Clamp clamp) {
  Refinement result;
  const double wanted = continuum(beta, kFlexibility);
  std::vector<double> values;
  for (int segments : {25, 50, 100, 200}) {
    // Twice as many free lengths (segments - 1/2) where the clamp is treated.
    values.push_back(deflection(context, beta, segments + 1, soft(kind), clamp));
    result.nodes.push_back(segments + 1);
    result.error.push_back(std::abs(values.back() - wanted));
  }
  const double ratio = clamp == Clamp::outer_node ? 2.0 : 199.5 / 99.5;
  result.order = std::log(result.error[2] / result.error[3]) / std::log(ratio);
  const double order = clamp == Clamp::outer_node ? 1.0 : 2.0;
  result.limit = extrapolated(values[2], values[3], order * std::log2(ratio));
  return result;
}

void compare_refinement(Context& context) {
  Chart chart;
  chart.title = "Heavy cantilever: distance from the continuum";
  chart.x_label = "nodes / 1";
  chart.y_label = "error of the tip's deflection / L";
  chart.log_x = chart.log_y = true;
  for (Clamp clamp : {Clamp::outer_node, Clamp::middle_of_segment}) {
    const bool treated = clamp == Clamp::middle_of_segment;
    const char* length = treated ? "length from the clamp's middle" : "length from the outer node";
    for (double beta : {1.0, 8.0, 32.0}) {
      const Refinement r = refine(context, beta, Bending::bounded, clamp);
      context.absolute(fmt::format("order in the mesh, beta = {}, {}", beta, length), "1", r.order,
                       treated ? 2.0 : 1.0, treated ? 0.005 : 0.01,
                       "next term of the error at 100 and 200 segments: h or h^2 relative to it");
      if (treated)
        context.relative(fmt::format("deflection, extrapolated, beta = {}, {}", beta, length), "L",
                         r.limit, continuum(beta, kFlexibility), 1e-7,
                         "h^4 of 100 segments, 1e-8, times derivatives");
      chart.curves.push_back({fmt::format("beta = {}, {}", beta, treated ? "middle" : "outer node"),
                              r.nodes, r.error, treated ? CurveStyle::line : CurveStyle::dashed});
    }
  }
  chart.caption =
      "Two held nodes clamp the middle of the segment between them. With the length measured from "
      "there the error falls with the square of the mesh, from the outer node in proportion to it.";
  chart.source = "continuum by shooting";
  context.chart(chart);
}

// The limit of few segments of a thread whose axial forces leave little round-off, at beta = 0.01.
double linear_limit(const Context& context) {
  const Material m = soft(Bending::bounded, 1e-3);
  const double coarse = deflection(context, 0.01, 12, m, Clamp::middle_of_segment);
  const double fine = deflection(context, 0.01, 23, m, Clamp::middle_of_segment);
  return extrapolated(coarse, fine, 2.0 * std::log2(21.5 / 10.5));
}

void compare_decades(Context& context) {
  Chart chart;
  chart.title = "Deflection of a heavy cantilever";
  chart.x_label = "rho A g L^3 / EI / 1";
  chart.y_label = "deflection of the tip / L";
  chart.log_x = true;
  const int nodes = context.quick() ? 51 : 101;
  Curve bounded{"bounded, 50 nodes", {}, {}, CurveStyle::line};
  Curve tangent{"tangent, 50 nodes", {}, {}, CurveStyle::dashed};
  Curve linear{"linear theory, beta / 8", {}, {}, CurveStyle::dashed};
  Curve exact{"elastica", {}, {}, CurveStyle::points};
  for (double power = -2.0; power < 2.01; power += 0.25) {
    const double beta = std::pow(10.0, power);
    exact.x.push_back(beta);
    exact.y.push_back(continuum(beta));
    bounded.x.push_back(beta);
    bounded.y.push_back(deflection(context, beta, 50, stiff(Bending::bounded), Clamp::outer_node));
    tangent.x.push_back(beta);
    tangent.y.push_back(deflection(context, beta, 50, stiff(Bending::tangent), Clamp::outer_node));
    linear.x.push_back(beta);
    linear.y.push_back(beta < 9.0 ? beta / 8.0 : std::nan(""));
    if (std::abs(power - std::round(power)) > 1e-9) continue;
    const double turn = cantilever(beta, 0.0).front().curvature, h = 1.0 / (nodes - 1.5);
    for (Bending kind : {Bending::bounded, Bending::tangent})
      context.relative(
          fmt::format("deflection, clamp's middle, beta = {:g}, {}", beta, name_of(kind)), "L",
          deflection(context, beta, nodes, stiff(kind), Clamp::middle_of_segment), continuum(beta),
          h * h * (1.0 + turn * turn / 12.0),
          "h^2 of the mesh, and (kappa h)^2 / 12 of the curvature's form at the clamp");
  }
  context.relative(
      "deflection, clamp's middle, beta = 0.01, by linear theory", "L", linear_limit(context),
      0.01 / 8.0, 4e-6,
      "the elastica itself differs by 0.0125 beta^2 = 1.3e-6; h^4 of 22 segments is 4e-6",
      "linear theory");
  chart.curves = {bounded, tangent, linear, exact};
  chart.caption =
      "L 1 m, E 1 GPa, r0 1 mm, rho 1000 kg/m3, 50 nodes, the first two clamped; gravity from "
      "0.0025 to 25 m/s2. The gap to the elastica is that of the clamp.";
  chart.source = "linear theory; continuum by shooting";
  context.chart(chart);
}

void run(Context& context) {
  compare_discrete(context);
  compare_shooting(context);
  compare_refinement(context);
  compare_decades(context);
  context.note(
      "Holding the first two nodes fixes a direction in the middle of the first segment, and the "
      "curvature of the joint at the second node is spread over half a segment on either side of "
      "it: the clamp sits half a segment h inside, and a line of 50 nodes is shorter by 1 %. In "
      "linear theory that costs 1 - (1 - h/2L)^4, 4 % of the deflection. Measuring the length from "
      "the middle of the clamped segment removes it, and the order in the mesh is two again.");
  context.note(
      "Linear theory is 1 % too large at beta = 0.9 and 80 % at beta = 10: its tip "
      "would be farther below the clamp than the line is long from beta = 8 on.");
}

}  // namespace

Case heavy_cantilever_case() {
  Case c;
  c.name = "heavy-cantilever";
  c.title = "Heavy cantilever: linear theory, elastica, both curvatures";
  c.group = Group::paper;
  c.figure = "Fig. 14";
  c.about =
      "A horizontal cantilever (L 1 m, E 1 GPa, r0 1 mm, rho 1000 kg/m3) under gravity, over four "
      "decades of beta = rho A g L^3 / EI. Compared: the deflection of its tip with the discrete "
      "problem's, linear theory's and the elastica's, with both curvatures, and the order at which "
      "it reaches the elastica.";
  c.source = "independent computation";
  c.guards = {"stretching", "bending", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

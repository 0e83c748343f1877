// One joint turned from straight to folded: both curvatures, and the moments that straighten it.
#include "verification/framework/case.hpp"

#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "retiarius/forces/bending.hpp"
#include "verification/framework/line.hpp"

namespace retiarius::verification {

namespace {

constexpr double kStiffness = 2e-3;            // EI, N m2
constexpr double kFirst = 0.8, kSecond = 1.1;  // segments, m
constexpr double kVoronoi = 0.5 * (kFirst + kSecond);
constexpr double kDegree = kPi / 180.0;

struct Turned {
  double curvature;  // from the energy: sqrt(2 E lv / EI)
  double moment;     // restoring, in EI / lv
};

// What the law says of the joint turned by phi in a plane that is no plane of axes.
Turned turn(const Context& context, Bending kind, double phi) {
  const Vec3 along = Vec3(2, -1, 2) / 3.0, across = Vec3(1, 2, 0).normalized();
  const Network net = line_through({Vec3::Zero(), kFirst * along, (kFirst + kSecond) * along},
                                   plain_thread(100.0, 0.1, kStiffness, kind));
  const std::unique_ptr<Law> law = context.law(std::make_unique<BendingLaw>(net));
  const Vec3 tangent = std::cos(phi) * along + std::sin(phi) * across;
  const Vec3 turning = -std::sin(phi) * along + std::cos(phi) * across;
  const std::vector<Vec3> x = {Vec3::Zero(), kFirst * along, kFirst * along + kSecond * tangent};
  std::vector<Vec3> gradient(3, Vec3::Zero());
  Assembly assembly{&gradient, nullptr, false};
  const Step step;
  law->assemble(step, x, assembly);
  return {std::sqrt(2.0 * law->potential(step, x) * kVoronoi / kStiffness),
          kSecond * gradient[2].dot(turning) * kVoronoi / kStiffness};
}

double wanted_curvature(Bending kind, double phi) {
  return 2.0 * (kind == Bending::bounded ? std::sin(0.5 * phi) : std::tan(0.5 * phi));
}

// kappa d(kappa)/d(phi).
double wanted_moment(Bending kind, double phi) {
  if (kind == Bending::bounded) return std::sin(phi);
  return 2.0 * std::tan(0.5 * phi) / std::pow(std::cos(0.5 * phi), 2);
}

const char* name_of(Bending kind) { return kind == Bending::bounded ? "bounded" : "tangent"; }

void compare(Context& context) {
  for (Bending kind : {Bending::bounded, Bending::tangent}) {
    for (double degrees : {0.01, 1.0, 30.0, 60.0, 90.0, 120.0, 150.0, 179.0}) {
      const double phi = degrees * kDegree;
      const Turned ours = turn(context, kind, phi);
      constexpr const char* kWhy =
          "round-off: eps of the directions over the angle 1.7e-4, eps of the cosine over 1 + c, "
          "1.5e-4 at 179 degrees; some ten operations";
      context.relative(fmt::format("curvature at {:g} deg, {}", degrees, name_of(kind)), "1",
                       ours.curvature, wanted_curvature(kind, phi), 2e-11, kWhy);
      context.relative(fmt::format("restoring moment at {:g} deg, {}", degrees, name_of(kind)),
                       "EI / lv", ours.moment, wanted_moment(kind, phi), 2e-11, kWhy);
    }
  }
  context.absolute("restoring moment at 180 deg, bounded", "EI / lv",
                   turn(context, Bending::bounded, kPi).moment, 0.0, 1e-14, "round-off");
}

Chart chart_of(const Context& context, bool moment) {
  Chart chart;
  chart.title =
      moment ? "Restoring moment against turning angle" : "Curvature against turning angle";
  chart.x_label = "turning angle / deg";
  chart.y_label = moment ? "moment / (EI / lv)" : "integrated curvature / 1";
  chart.caption = moment
                      ? "The bounded moment falls beyond 90 degrees and vanishes when folded; the "
                        "tangent one has no bound (drawn to 120 degrees)."
                      : "Bounded 2 sin(phi/2), tangent 2 tan(phi/2) (drawn to 150 degrees).";
  chart.source = "Huang et al. 2022, Eqs. 7 and 8; exact formulas";
  for (Bending kind : {Bending::bounded, Bending::tangent}) {
    const int last = kind == Bending::bounded ? 180 : moment ? 120 : 150;
    Curve ours{fmt::format("{}, the law", name_of(kind)), {}, {}, CurveStyle::line};
    Curve exact{fmt::format("{}, exact", name_of(kind)), {}, {}, CurveStyle::points};
    for (int degrees = 0; degrees <= last; ++degrees) {
      const double phi = degrees * kDegree;
      const Turned turned = turn(context, kind, phi);
      ours.x.push_back(degrees);
      ours.y.push_back(moment ? turned.moment : turned.curvature);
      if (degrees % 10 != 0) continue;
      exact.x.push_back(degrees);
      exact.y.push_back(moment ? wanted_moment(kind, phi) : wanted_curvature(kind, phi));
    }
    chart.curves.push_back(ours);
    chart.curves.push_back(exact);
  }
  return chart;
}

void run(Context& context) {
  compare(context);
  context.chart(chart_of(context, false));
  context.chart(chart_of(context, true));
  context.note(
      "Both curvatures are the turning angle itself for small angles: they differ by phi^3 / 8, so "
      "a "
      "rod of many segments cannot tell them apart. They part where a thread is folded within one "
      "joint: there the tangent one forbids what the bounded one lets pass at a cost of 2 EI / "
      "lv.");
}

}  // namespace

Case curvatures_case() {
  Case c;
  c.name = "curvatures";
  c.title = "Both curvatures against turning angle";
  c.group = Group::paper;
  c.figure = "Fig. 13";
  c.about =
      "One joint between segments of 0.8 and 1.1 m is turned from 0 to 180 degrees. Energy and "
      "gradient of the bending law give curvature and restoring moment, compared with "
      "2 sin(phi/2) and 2 tan(phi/2) and their derivatives.";
  c.source = "exact formulas; Huang et al. 2022, Eqs. 7 and 8";
  c.guards = {"bending"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

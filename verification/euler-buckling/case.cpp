// A pinned line under end pressure: its frequency falls to nothing at Euler's load, and beyond it
// it bends.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/elastica.hpp"
#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"
#include "verification/framework/swing.hpp"

namespace retiarius::verification {

namespace {

constexpr int kSegments = 20;
constexpr double kAxial = 1e6;  // EA; L = EI = rho A = 1

// Euler's load of n equal segments, EI = L = 1: the half wave is a mode of the discrete line too.
double discrete_load(int segments) {
  return std::pow(2.0 * segments * std::sin(0.5 * kPi / segments), 2);
}

// Squared frequency of the half wave under the end load: bending minus load, over the mass, with
// the segments as short as the load makes them. Rest lengths define the joints' stiffness.
double wanted_square(double load) {
  const double n = kSegments, wave = 4.0 * std::pow(std::sin(0.5 * kPi / n), 2);
  const double rest = 1.0 / n, length = rest * (1.0 - load / kAxial);
  const double bending = wave * wave / (rest * length * length);
  return (bending - load * wave / length) / rest;
}

// Squared frequency as observed while the line swings in its half wave with a small amplitude.
double squared_frequency_under(const Context& context, double load) {
  Network net = straight_line(kSegments, 1.0, plain_thread(kAxial, 1.0, 1.0));
  const double length = 1.0 - load / kAxial;
  for (Index k = 0; k <= kSegments; ++k) {
    const double s = static_cast<double>(k) / kSegments;
    net.initial[k] = {s * length, 0.0, 1e-6 * std::sin(kPi * s)};
  }
  const std::vector<Prescribed> ends = held(net, {0, kSegments});
  const std::vector<Body> none;
  Simulation simulation = context.simulation(net, none);
  simulation.configure({}, with(Method::newmark, 0.02, 1e-10), {});
  std::vector<double> z = {net.initial[kSegments / 2].z()};
  // What grows is watched while its amplitude still stretches nothing.
  const int steps = load > discrete_load(kSegments) ? 10 : 40;
  advance(simulation, 0.02, steps, ends,
          [&](int) { z.push_back(simulation.state().x[kSegments / 2].z()); });
  return squared_frequency(z, 0.02);
}

void compare_swing(Context& context) {
  const double critical = discrete_load(kSegments);
  Chart chart;
  chart.title = "Square of the lowest frequency against end load";
  chart.x_label = "load / Euler's load";
  chart.y_label = "squared frequency / that without load";
  Curve ours{"20 segments, observed", {}, {}, CurveStyle::points};
  std::vector<double> squares;
  const std::vector<double> shares = {-1.0, -0.5, 0.0, 0.5, 0.9, 1.1, 1.5};
  for (double share : shares) {
    squares.push_back(squared_frequency_under(context, share * critical));
    ours.x.push_back(share);
    ours.y.push_back(squares.back() / wanted_square(0.0));
    context.absolute(
        fmt::format("squared frequency at {} of Euler's load", share), "of that without load",
        ours.y.back(), wanted_square(share * critical) / wanted_square(0.0), 2e-6,
        "the swing stretches the line: EA (pi A / 2)^2 = 2.5e-6 N of a load of 10 N, 16 times that "
        "where it grows fourfold",
        "exact frequency of the discrete line");
  }
  // The load at which the square would vanish, from two observations.
  const double root = 0.5 + 0.4 * squares[3] / (squares[3] - squares[4]);
  context.relative("load at which the frequency vanishes", "EI / L^2", root * critical, kPi * kPi,
                   3e-3, "20 segments: pi^2 / (12 n^2) = 2.06e-3, of known sign", "pi^2 EI / L^2");
  context.relative("load at which the frequency vanishes, 20 segments", "EI / L^2", root * critical,
                   critical, 2e-5,
                   "the load shortens the segments by 1e-5, which stiffens the bend",
                   "exact load of the discrete line");
  chart.curves = {ours, {"1 - P / P_E", {-1.0, 1.5}, {2.0, -0.5}, CurveStyle::dashed}};
  chart.caption =
      "Pinned line of 20 segments in its half wave, Newmark, amplitude 1e-6 L; negative squares: "
      "it "
      "grows.";
  chart.source = "exact: the square falls in proportion to the load";
  context.chart(chart);
}

struct Bent {
  double load, deflection;
};

Bent bend(const Context& context, double span, int segments) {
  Network net = straight_line(segments, 1.0, plain_thread(1e8, 1.0, 1.0));
  lay_on_arc(net, span);
  const State s = equilibrium(context, net, Vec3::Zero(), {0, segments});
  return {-s.support[segments].x() / (kPi * kPi), -s.x[segments / 2].z()};
}

void compare_bent(Context& context) {
  Chart chart;
  chart.title = "Post-buckling of a pinned line";
  chart.x_label = "deflection of the middle / L";
  chart.y_label = "load / Euler's load";
  Curve ours{"40 segments", {}, {}};
  Curve exact{"Euler's elastica", {}, {}, CurveStyle::points};
  for (double slope = 10.0; slope <= 130.0; slope += context.quick() ? 20.0 : 5.0) {
    const Elastica wanted = elastica(std::sin(0.5 * slope * kPi / 180.0));
    const Bent coarse = bend(context, wanted.span, 40);
    ours.x.push_back(coarse.deflection);
    ours.y.push_back(coarse.load);
    exact.x.push_back(wanted.deflection);
    exact.y.push_back(wanted.load);
    if (std::fmod(slope, 20.0) != 10.0) continue;
    const Bent fine = bend(context, wanted.span, 80);
    const std::string at = fmt::format("end slope {} deg", slope);
    // At 10 degrees the ends approach by 0.0076 L only: the strain 1e-7 is 1.3e-5 of it.
    constexpr const char* kWhy =
        "strain 1e-7 to 2e-7 against ends that approach by 0.0076 L at 10 "
        "degrees; h^4 of 40 segments, 4e-7, times derivatives";
    context.relative("deflection, extrapolated, " + at, "L",
                     extrapolated(coarse.deflection, fine.deflection), wanted.deflection, 2e-5,
                     kWhy);
    context.relative("load, extrapolated, " + at, "P_E", extrapolated(coarse.load, fine.load),
                     wanted.load, 2e-5, kWhy);
  }
  chart.curves = {ours, exact};
  chart.caption = "Pinned ends brought together, end slopes from 10 to 130 degrees; no weight.";
  chart.source = "elastica in closed form";
  context.chart(chart);
}

void run(Context& context) {
  compare_swing(context);
  compare_bent(context);
}

}  // namespace

Case euler_buckling_case() {
  Case c;
  c.name = "euler-buckling";
  c.title = "Euler buckling and post-buckling";
  c.group = Group::rods;
  c.about =
      "A pinned line (L = EI = rho A = 1) under end load. Compared: the square of its lowest "
      "frequency, which falls in proportion to the load and vanishes at Euler's; and, with its "
      "ends "
      "brought together, load and deflection with the elastica.";
  c.source = "Euler's elastica in closed form (complete elliptic integrals)";
  c.guards = {"stretching", "bending", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

// Standing waves of a stretched string, across it and along it.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/oscillation.hpp"

namespace retiarius::verification {

namespace {

constexpr double kLength = 1.0;       // m, unstretched
constexpr double kStiffness = 100.0;  // EA, N
constexpr double kLine = 0.01;        // kg/m, unstretched
constexpr double kStrain = 0.02;
constexpr double kTension = kStiffness * kStrain;

Network stretched(int segments) {
  Network net = straight_line(segments, kLength, plain_thread(kStiffness, kLine));
  for (Vec3& x : net.initial) x *= 1.0 + kStrain;
  return net;
}

// Frequency of the lattice (rad/s) with `waves` half waves between the held ends.
double lattice(int segments, int waves, bool along) {
  const double l = kLength / segments;
  const double k = along ? kStiffness / l : kTension / (l * (1.0 + kStrain));
  return 2.0 * std::sqrt(k / (kLine * l)) * std::sin(0.5 * kPi * waves / segments);
}

struct Wave {
  double unwarped = 0.0;  // rad/s, the scheme's warping taken away
  double seen = 0.0;      // rad/s, as it is in the run
};

// Started by velocities of the shape sin(q s).
Wave measured(Context& context, int segments, int waves, bool along, Method method, double h) {
  Network net = stretched(segments);
  const double omega = lattice(segments, waves, along);
  const Vec3 direction = along ? Vec3::UnitX() : Vec3::UnitZ();
  std::vector<double> shape;
  for (Index k = 0; k <= segments; ++k) shape.push_back(std::sin(kPi * waves * k / segments));
  for (Index k = 1; k < segments; ++k)
    net.velocity[k] = 1e-5 * kLength / segments * omega * shape[k] * direction;
  Simulation sim = context.simulation(net, kNoBodies);
  sim.configure({}, with(method, h, 1e-12), {});
  const double period = 2.0 * kPi / omega;
  std::vector<double> amplitude{0.0};
  const int count = std::max(40, static_cast<int>(1.5 * period / h));
  advance(sim, h, count, held(net, {0, segments}), [&](int) {
    double sum = 0.0;
    for (std::size_t k = 0; k < shape.size(); ++k)
      sum += shape[k] * direction.dot(sim.state().x[k] - net.initial[k]);
    amplitude.push_back(sum);
  });
  const double warped = 2.0 * std::atan(0.5 * omega * h) / h;
  const int quarter = std::max(1, static_cast<int>(std::lround(0.5 * kPi / (warped * h))));
  const std::complex<double> z = measured_factor(amplitude, quarter);
  return {exponent_of(z, method, h).imag(), std::arg(z) / h};
}

void compare_dispersion(Context& context, bool along, Chart& chart) {
  const int segments = 20;
  const double top = lattice(segments, segments, along);
  const char* kind = along ? "longitudinal" : "transverse";
  const double unit = top / 2.0;
  Curve line{fmt::format("lattice, {}", kind), {}, {}, CurveStyle::line};
  for (int k = 0; k <= 100; ++k) {
    line.x.push_back(0.01 * k * kPi);
    line.y.push_back(2.0 * std::sin(0.005 * k * kPi));
  }
  if (!along) chart.curves.push_back(line);
  for (Method method : {Method::midpoint, Method::newmark}) {
    Curve points{fmt::format("{}, {}", kind, to_string(method)), {}, {}, CurveStyle::points};
    for (int waves : {1, 2, 5, 10, 15, 19}) {
      const double h = 0.25 / lattice(segments, 10, along);
      const Wave w = measured(context, segments, waves, along, method, h);
      const double wanted = lattice(segments, waves, along);
      context.relative(fmt::format("{} frequency at q a = {:.2f} pi, {}", kind,
                                   static_cast<double>(waves) / segments, to_string(method)),
                       "rad/s", w.unwarped, wanted, 1e-7,
                       "the scheme's warping is taken out exactly: (2/h) tan(omega h/2); waves of "
                       "1e-5 of a segment");
      context.relative(fmt::format("{} frequency seen at q a = {:.2f} pi, {}", kind,
                                   static_cast<double>(waves) / segments, to_string(method)),
                       "rad/s", w.seen, 2.0 / h * std::atan(0.5 * wanted * h), 1e-7,
                       "as it runs: (2/h) atan(omega h/2)");
      points.x.push_back(kPi * waves / segments);
      points.y.push_back(w.unwarped / unit);
    }
    if (method == Method::midpoint) chart.curves.push_back(points);
  }
}

// Speed of the longest wave against the continuum's; q a is small.
void compare_speeds(Context& context) {
  const int segments = context.quick() ? 100 : 400;
  const double qa = kPi / segments, q = kPi / kLength;  // per unstretched length
  for (bool along : {false, true}) {
    const double omega = lattice(segments, 1, along);
    const Wave w =
        measured(context, segments, 1, along, Method::midpoint, 2.0 * kPi / omega / 100.0);
    // A string carries its stretched line density, kLine / (1 + strain).
    const double length = along ? 1.0 : 1.0 + kStrain;
    const double line = along ? kLine : kLine / (1.0 + kStrain);
    const double wanted = std::sqrt((along ? kStiffness : kTension) / line);
    context.relative(along ? "c_l, longest wave" : "c_t, longest wave", "m/s",
                     w.unwarped / (q / length), wanted, 1.05 * qa * qa / 24.0,
                     "the lattice's own delay (q a)^2 / 24",
                     along ? "exact: sqrt(EA / m')" : "exact: sqrt(T / m'), m' of the stretched");
  }
}

void run(Context& context) {
  Chart chart;
  chart.title = "Dispersion of waves in a thread of nodes";
  chart.x_label = "wave number times segment, q a / rad";
  chart.y_label = "frequency / sqrt(k/m)";
  for (bool along : {false, true}) compare_dispersion(context, along, chart);
  compare_speeds(context);
  Curve straight{"continuum", {0.0, 2.0}, {0.0, 2.0}, CurveStyle::dashed};
  chart.curves.push_back(straight);
  chart.caption =
      "Standing waves in 20 segments, EA 100 N, 0.01 kg/m, stretched by 2 %; k = T/l across, EA/l0 "
      "along; the midpoint rule's warping of the frequency taken out exactly.";
  chart.source = "exact: 2 |sin(q a / 2)|";
  context.chart(chart);
  context.note(
      "A scheme turns the exponent s of a linear motion into a power z of its own: midpoint and "
      "Newmark's trapezoid into z = (1 + h s/2) / (1 - h s/2). z is measured by least squares from "
      "the samples and turned back, so the comparison with the lattice has no error of the step.");
}

}  // namespace

Case string_waves_case() {
  Case c;
  c.name = "string-waves";
  c.title = "Waves in a string: speeds and dispersion";
  c.group = Group::dynamics;
  c.about =
      "Standing waves across and along a stretched thread (EA 100 N, 0.01 kg/m, 2 % strain) "
      "between held ends. Compared: their frequencies with the lattice's 2 sqrt(k/m) |sin(q a/2)| "
      "up to the shortest wave, the longest wave's speed with sqrt(T/m') and sqrt(EA/m').";
  c.source = "exact: 2 sqrt(k/m) |sin(q a/2)|";
  c.guards = {"stretching", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

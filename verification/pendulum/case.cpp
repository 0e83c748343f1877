// A mass on a stiff thread swings widely.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "verification/framework/line.hpp"

namespace retiarius::verification {

namespace {

constexpr double kLength = 1.0;  // m
constexpr double kMass = 1.0;    // kg
constexpr double kGravity = 9.81;
constexpr double kStiffness = 1e6 * kMass * kGravity;  // EA, N

struct Swing {
  std::vector<double> t, angle;  // s, degrees
  double period = 0.0;           // s, over that of small swings
  double tension = 0.0;          // largest, N
};

// Let go at the angle, stretched as its weight along the thread asks.
Swing swing(Context& context, double angle_deg, double h, double swings) {
  const double angle = radians(angle_deg);
  const Vec3 down(std::sin(angle), 0.0, -std::cos(angle));
  Network net = straight_line(1, kLength, plain_thread(kStiffness, 1e-9), down);
  net.mass[1] = kMass;
  net.initial[1] *= 1.0 + kMass * kGravity * std::cos(angle) / kStiffness;
  Simulation sim = context.simulation(net, kNoBodies);
  sim.configure({{0, 0, -kGravity}, 0.0}, with(Method::midpoint, h), {});
  const double small = 2.0 * kPi * std::sqrt(kLength / kGravity);
  Swing result{{0.0}, {angle_deg}};
  std::vector<double> passes;
  advance(sim, h, static_cast<int>(swings * 1.8 * small / h), held(net, {0}), [&](int) {
    const Vec3& x = sim.state().x[1];
    const double before = result.angle.back(), now = degrees(std::atan2(x.x(), -x.z()));
    const double time = result.t.back();
    if (before * now < 0.0) passes.push_back(time + h * before / (before - now));
    result.t.push_back(sim.state().time);
    result.angle.push_back(now);
    result.tension = std::max(result.tension, sim.tensions()[0]);
  });
  if (passes.size() > 2) result.period = (passes[2] - passes[0]) / small;
  return result;
}

void run(Context& context) {
  const double h = 5e-4;
  Chart chart;
  chart.title = "Period of a pendulum";
  chart.x_label = "amplitude / degrees";
  chart.y_label = "period / period of small swings";
  Curve ours{"midpoint", {}, {}, CurveStyle::points}, exact{"exact", {}, {}, CurveStyle::line};
  Chart swings;
  swings.title = "Swings of a pendulum";
  swings.x_label = "time / s";
  swings.y_label = "angle / degrees";
  swings.caption = "Let go at rest from 30, 60, 90 and 120 degrees; one period each and its end.";
  swings.source = "the periods' ends: complete elliptic integral";
  Curve ends{"exact periods", {}, {}, CurveStyle::points};
  const double small = 2.0 * kPi * std::sqrt(kLength / kGravity);
  const std::vector<std::pair<double, double>> printed = {
      {30, 1.01740880}, {60, 1.07318201}, {90, 1.18034060}, {120, 1.37288050}};
  for (int k = 0; k <= 150; ++k) {
    exact.x.push_back(k);
    exact.y.push_back(2.0 / kPi * std::comp_ellint_1(std::sin(0.5 * radians(k))));
  }
  for (const auto& [angle, wanted] : printed) {
    const Swing s = swing(context, angle, h, 1.0);
    Curve path{fmt::format("{:g} deg", angle), {}, {}, CurveStyle::line};
    for (std::size_t k = 0; k < s.t.size() && s.t[k] <= wanted * small; k += 10) {
      path.x.push_back(s.t[k]);
      path.y.push_back(s.angle[k]);
    }
    swings.curves.push_back(path);
    ends.x.push_back(wanted * small);
    ends.y.push_back(angle);
    ours.x.push_back(angle);
    ours.y.push_back(s.period);
    context.relative(fmt::format("period over that of small swings, {:g} deg", angle), "1",
                     s.period, wanted, 4e-6,
                     "the thread's strain, up to 3e-6, lengthens the period by half of it; the "
                     "midpoint rule by (omega h)^2 / 12 = 8e-7");
    context.relative(fmt::format("largest tension, {:g} deg", angle), "N", s.tension,
                     kMass * kGravity * (3.0 - 2.0 * std::cos(radians(angle))), 1e-5,
                     "strain up to 4e-6, and the thread's ringing about it",
                     "exact: m g (3 - 2 cos)");
  }
  swings.curves.push_back(ends);
  chart.curves = {exact, ours};
  chart.caption = fmt::format(
      "1 kg on 1 m of thread, EA = 1e6 m g, midpoint, h = {:g} ms; exact: 2 K(sin(a/2)) / pi.",
      1e3 * h);
  chart.source = "complete elliptic integral of the first kind";
  context.chart(chart);
  context.chart(swings);
}

}  // namespace

Case pendulum_case() {
  Case c;
  c.name = "pendulum";
  c.title = "Pendulum of large amplitude";
  c.group = Group::dynamics;
  c.about =
      "A mass of 1 kg on a stiff thread of 1 m is let go at 30, 60, 90 and 120 degrees (midpoint "
      "rule). Compared: its period with the elliptic integral, its largest tension with the exact "
      "one.";
  c.source = "exact: 2 K(sin(a/2)) / pi";
  c.guards = {"stretching", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

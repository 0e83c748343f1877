// A rigid body tumbles without torque about its middle axis.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace retiarius::verification {

namespace {

// Euler's equations for I = (1, 2, 3), w = (0.01, 1, 0) at first: w2 = w2max cn-like of period
// 4 K / p, its first zero after K / p.
double quarter_period() {
  const double i1 = 1.0, i2 = 2.0, i3 = 3.0, w1 = 0.01, w2 = 1.0;
  const double twice_energy = i1 * w1 * w1 + i2 * w2 * w2;
  const double momentum2 = i1 * i1 * w1 * w1 + i2 * i2 * w2 * w2;
  const double fast = (i2 - i1) * (twice_energy * i3 - momentum2);
  const double slow = (i3 - i2) * (momentum2 - twice_energy * i1);
  return std::comp_ellint_1(std::sqrt(slow / fast)) / std::sqrt(fast / (i1 * i2 * i3));
}

Chart spin_chart(const std::array<Curve, 3>& curves, std::size_t flips) {
  const double quarter = quarter_period();
  Chart chart;
  chart.title = "Spin of a body about its middle axis";
  chart.x_label = "time / s";
  chart.y_label = "spin in body axes / rad/s";
  for (std::size_t i = 0; i < 3; ++i) {
    Curve c{fmt::format("w{}", i + 1), {}, {}, CurveStyle::line};
    for (std::size_t k = 0; k < curves[i].x.size(); k += 3) {
      c.x.push_back(curves[i].x[k]);
      c.y.push_back(curves[i].y[k]);
    }
    chart.curves.push_back(c);
  }
  Curve zeros{"exact flips", {}, {}, CurveStyle::points};
  for (std::size_t k = 0; k < flips; ++k) {
    zeros.x.push_back((2.0 * static_cast<double>(k) + 1.0) * quarter);
    zeros.y.push_back(0.0);
  }
  chart.curves.push_back(zeros);
  chart.caption = "Moments of inertia 1, 2, 3 kg m2, spin (0.01, 1, 0) rad/s at first, no torque.";
  chart.source = "Euler's equations: K(k) / p and odd multiples";
  return chart;
}

void run(Context& context) {
  const MissionRun r =
      context.run("mission", context.quick() ? std::vector<std::string>{"phase[0].until=time >= 60"}
                                             : std::vector<std::string>{});
  const Body& body = r.model->bodies[0];
  std::array<Curve, 3> curves;
  std::vector<double> flips;
  double energy_drift = 0.0, momentum_drift = 0.0;
  const double energy = kinetic_energy(body, r.frames.front().bodies[0]);
  const Vec3 momentum = r.frames.front().bodies[0].angular_momentum;
  for (std::size_t k = 0; k < r.frames.size(); ++k) {
    const BodyState& s = r.frames[k].bodies[0];
    const Vec3 w = s.attitude.conjugate() * spin(body, s);
    const double t = r.frames[k].time;
    if (k > 0) {
      const double before = curves[1].y.back();
      if (before * w.y() < 0.0)
        flips.push_back(t - (t - curves[1].x.back()) * w.y() / (w.y() - before));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      curves[i].x.push_back(t);
      curves[i].y.push_back(w[static_cast<Index>(i)]);
    }
    energy_drift = std::max(energy_drift, std::abs(kinetic_energy(body, s) / energy - 1.0));
    momentum_drift = std::max(momentum_drift, (s.angular_momentum - momentum).norm());
  }
  const double quarter = quarter_period();
  const std::vector<double> printed = {10.3773, 31.1319, 51.8865};
  for (std::size_t k = 0; k < printed.size(); ++k)
    context.absolute(fmt::format("flip {}", k + 1), "s", flips.at(k), printed[k], 1e-4,
                     "one unit of the last printed digit", "independent computation");
  for (std::size_t k = 0; k < flips.size(); ++k)
    context.absolute(fmt::format("flip {}", k + 1), "s", flips[k],
                     (2.0 * static_cast<double>(k) + 1.0) * quarter, 5e-6,
                     "attitude to 1e-10 rad a step, its error grown by the unstable axis; "
                     "crossings interpolated between steps of 0.05 s");
  context.absolute("largest change of the energy over the energy", "1", energy_drift, 0.0, 1e-10,
                   "attitude to 1e-10 rad a step, over 4200 steps");
  context.absolute("largest change of the angular momentum", "kg m2/s", momentum_drift, 0.0, 0.0,
                   "it is carried, so it stays the same bit for bit");
  if (!context.quick())
    context.absolute("flips in 210 s", "1", static_cast<double>(flips.size()), 10.0, 0.0,
                     "a whole number");
  context.chart(spin_chart(curves, flips.size()));
}

}  // namespace

Case tumbling_case() {
  Case c;
  c.name = "tumbling";
  c.title = "Torque-free tumbling about the middle axis";
  c.group = Group::dynamics;
  c.about =
      "A body of moments of inertia 1, 2, 3 kg m2 spins about its middle axis, (0.01, 1, 0) rad/s, "
      "and flips over ten times in 210 s. Compared: the times of the flips with the elliptic "
      "integral; energy and angular momentum with those at the start.";
  c.source = "exact: Euler's equations, complete elliptic integral";
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

// Masses on a tether spin about each other in free space.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/measure/energy.hpp"
#include "retiarius/measure/momentum.hpp"
#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/reference_chain.hpp"

namespace retiarius::verification {

namespace {

constexpr double kLength = 10.0;       // m
constexpr double kStiffness = 2000.0;  // EA, N
constexpr double kMass = 2.0;          // kg, each

// Two equal masses on one massless segment.
Network pair_of_masses() {
  Network net = straight_line(1, kLength, plain_thread(kStiffness, 1e-12));
  for (int i : {0, 1}) {
    net.mass[i] = kMass;
    net.initial[i].x() -= 0.5 * kLength;
  }
  return net;
}

// Circles of the midpoint rule. A turn by theta a step has its stages at rho = r cos(theta/2), and
// inserting it in the scheme gives w^2 = T(2 rho) / (m rho) with w = (2/h) tan(theta/2), speed w r.
void compare_circle(Context& context) {
  Network net = pair_of_masses();
  const double rho = 0.55 * kLength, h = 0.02;
  const double pull = kStiffness * (2.0 * rho / kLength - 1.0);
  const double w = std::sqrt(pull / (kMass * rho));
  const double theta = 2.0 * std::atan(0.5 * h * w);
  const double radius = rho / std::cos(0.5 * theta);
  for (int i : {0, 1}) {
    const double side = i == 0 ? -1.0 : 1.0;
    net.initial[i] = {side * radius, 0, 0};
    net.velocity[i] = {0, side * w * radius, 0};
  }
  Simulation sim = context.simulation(net, kNoBodies);
  sim.configure({}, with(Method::midpoint, h, 1e-12), {});
  double turned = 0.0, before = 0.0, off = 0.0;
  const int steps = context.quick() ? 1000 : 5000;
  advance(sim, h, steps, {}, [&](int) {
    const Vec3& x = sim.state().x[1];
    const double now = std::atan2(x.y(), x.x());
    turned += std::remainder(now - before, 2.0 * kPi);
    before = now;
    off = std::max(off, std::abs(x.norm() / radius - 1.0));
  });
  context.relative("frequency of a circle, midpoint", "rad/s",
                   2.0 / h * std::tan(0.5 * turned / steps), w, 1e-9,
                   "exact for the scheme: its warping (2/h) tan(theta/2) is taken out",
                   "exact: w^2 = EA (2 rho / l0 - 1) / (m rho), rho the radius of the stages");
  context.absolute("change of the circle's radius over the radius", "1", off, 0.0, 1e-9,
                   "exact for the scheme; Newton's tolerance of 1e-12, grown with the turns",
                   "exact");
}

// Masses that swing and turn.
Network thrown_pair() {
  Network start = pair_of_masses();
  for (int i : {0, 1}) {
    start.initial[i] *= 1.3;
    start.velocity[i] = {0, i == 0 ? -4.0 : 4.0, 0.5};
  }
  return start;
}

// Their orbit against Runge-Kutta: errors at h and h/2.
void compare_orbit(Context& context) {
  const Network start = thrown_pair();
  const double time = context.quick() ? 5.0 : 20.0, row = 0.02;
  const int rows = static_cast<int>(std::lround(time / row));
  ReferenceChain chain(start);
  Curve wanted{"reference", {0.0}, {2.0 * chain.x[1].x()}, CurveStyle::dashed};
  std::vector<Vec3> places{chain.x[1]};
  for (int k = 1; k <= rows; ++k) {
    chain.advance(row, 40);
    wanted.x.push_back(k * row);
    wanted.y.push_back((chain.x[1] - chain.x[0]).norm());
    places.push_back(chain.x[1]);
  }
  Chart chart;
  chart.title = "Distance of two masses on a spring";
  chart.x_label = "time / s";
  chart.y_label = "distance / m";
  std::vector<double> errors;
  std::vector<std::vector<Vec3>> runs;
  for (double h : {0.02, 0.002, 0.001}) {
    Network net = start;
    Simulation sim = context.simulation(net, kNoBodies);
    sim.configure({}, with(Method::midpoint, h, 1e-12), {});
    Curve curve{
        fmt::format("midpoint, h = {:g} ms", 1e3 * h), {0.0}, {wanted.y[0]}, CurveStyle::line};
    const int each = static_cast<int>(std::lround(row / h));
    double worst = 0.0;
    runs.push_back({net.initial[1]});
    advance(sim, h, each * rows, {}, [&](int n) {
      if (n % each != 0) return;
      const State& s = sim.state();
      curve.x.push_back(s.time);
      curve.y.push_back((s.x[1] - s.x[0]).norm());
      runs.back().push_back(s.x[1]);
      worst = std::max(worst, (s.x[1] - places[runs.back().size() - 1]).norm());
    });
    errors.push_back(worst);
    if (h != 0.002) chart.curves.push_back(curve);
  }
  double limit = 0.0;  // extrapolated from the last two
  for (std::size_t k = 0; k < places.size(); ++k)
    limit = std::max(limit, ((4.0 * runs[2][k] - runs[1][k]) / 3.0 - places[k]).norm());
  const double omega = std::sqrt(2.0 * kStiffness / (kLength * kMass));
  const double lag = std::pow(omega * 1e-3, 2) / 12.0 * omega * time;
  const std::string source = "the same equations written anew, classical Runge-Kutta";
  context.absolute(
      "largest distance to the reference, h = 1 ms", "m", errors[2], 0.0, 1.2 * 1.5 * lag,
      "the midpoint rule lags by (omega h)^2 / 12 a rad, at 14 rad/s and 1.5 m", source);
  context.absolute("largest distance to the reference, extrapolated", "m", limit, 0.0,
                   3.3 * lag * lag, "what extrapolation leaves of a lag f is 2 f^2, at 1.5 m",
                   source);
  context.absolute("order of that distance in the step", "1", std::log2(errors[1] / errors[2]), 2.0,
                   0.02, "the midpoint rule's order", "theory of the scheme");
  chart.curves.push_back(wanted);
  chart.caption =
      "Two masses of 2 kg on 10 m of thread, EA 2000 N, at first stretched by 30 % and XX.";
  chart.source = "the same equations written anew, classical Runge-Kutta";
  context.chart(chart);
}

// A tether of 20 segments between unequal masses that drifts, spins and swings.
void compare_conservation(Context& context, Method method, double tau) {
  Material material = plain_thread(kStiffness, 0.4);
  material.damping = tau;
  Network net = straight_line(20, kLength, material);
  net.mass[0] += 5.0;
  net.mass[20] += 1.0;
  for (Index k = 0; k <= 20; ++k) {
    net.initial[k] *= 1.02;
    const double s = k / 20.0;
    net.velocity[k] = {0.1, -0.5 + 5.0 * s, 0.3 + 0.4 * std::sin(kPi * s)};
  }
  Simulation sim = context.simulation(net, kNoBodies);
  const double h = 0.002;
  const int steps = context.quick() ? 400 : 4000;
  sim.configure({}, with(method, h, 1e-12), {});
  const auto energy = [&] {
    return kinetic_energy(net, kNoBodies, sim.state()) + sim.stretching_energy() +
           sim.state().account.material_loss;
  };
  const Vec3 p = linear_momentum(net, kNoBodies, sim.state());
  const Vec3 l = angular_momentum(net, kNoBodies, sim.state(), Vec3::Zero());
  const double p_scale = linear_scale(net, kNoBodies, sim.state());
  const double e = energy();
  double p_off = 0.0, l_off = 0.0, e_off = 0.0;
  advance(sim, h, steps, {}, [&](int) {
    const State& s = sim.state();
    p_off = std::max(p_off, (linear_momentum(net, kNoBodies, s) - p).norm() / p_scale);
    l_off =
        std::max(l_off, (angular_momentum(net, kNoBodies, s, Vec3::Zero()) - l).norm() / l.norm());
    e_off = std::max(e_off, std::abs(energy() / e - 1.0));
  });
  const std::string what =
      fmt::format("{}{}", to_string(method), tau > 0.0 ? ", material damping" : "");
  const double round_off = 2.2e-16 * kLength / h * std::sqrt(steps);  // over 1 m/s
  context.absolute("change of linear momentum, " + what, "1", p_off, 0.0, round_off,
                   "round-off: velocities are differences of places over h; eps 10 m / h a step, "
                   "adding up as the root of their number",
                   "conserved");
  if (method != Method::midpoint) return;
  context.absolute("change of angular momentum, " + what, "1", l_off, 0.0, round_off,
                   "the midpoint rule keeps it; round-off as in linear momentum", "conserved");
  context.absolute("change of energy and losses, " + what, "1", e_off, 0.0, 5e-4,
                   "second order in the step: c h / l = 0.28, the axial waves are resolved",
                   "conserved");
}

void run(Context& context) {
  compare_circle(context);
  compare_orbit(context);
  for (Method method : {Method::implicit_euler, Method::newmark, Method::midpoint})
    for (double tau : {0.0, 1e-3}) compare_conservation(context, method, tau);
}

}  // namespace

Case tether_case() {
  Case c;
  c.name = "tether";
  c.title = "Masses on a tether: orbit and conservation";
  c.group = Group::dynamics;
  c.about =
      "Two masses of 2 kg on a spring of 10 m (EA 2000 N) circle each other, then swing; a tether "
      "of 20 segments between 5 and 1 kg drifts, spins and swings, without gravity. Compared: the "
      "circle's frequency with its closed form, the swinging orbit with a Runge-Kutta solution, "
      "momenta and energy with those at the start.";
  c.source = "exact";
  c.guards = {"stretching", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

// Kelvin-Voigt damping of a thread and the environment's damping of its nodes.
#include "verification/framework/case.hpp"

#include <cmath>

#include <fmt/format.h>

#include "retiarius/motion/integrator.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/oscillation.hpp"

namespace retiarius::verification {

namespace {

constexpr Method kMethods[] = {Method::implicit_euler, Method::newmark, Method::midpoint};
constexpr double kOmega = 20.0;  // rad/s, of the undamped pair of masses
constexpr double kLength = 1.0, kMass = 1.0;

// Two masses on a massless thread swing along it; the elongation at every step, m.
std::vector<double> elongation(Context& context, Method method, double zeta, double h, int steps) {
  Material material = plain_thread(0.5 * kMass * kOmega * kOmega * kLength, 1e-12);
  material.damping = 2.0 * zeta / kOmega;
  Network net = straight_line(1, kLength, material);
  for (double& m : net.mass) m = kMass;
  net.velocity = {{-0.5, 0, 0}, {0.5, 0, 0}};
  Simulation sim = context.simulation(net, kNoBodies);
  sim.configure({}, with(method, h, 1e-12), {});
  std::vector<double> result{0.0};
  advance(sim, h, steps, {},
          [&](int) { result.push_back(sim.state().x[1].x() - sim.state().x[0].x() - kLength); });
  return result;
}

void compare_material(Context& context) {
  Chart chart;
  chart.title = "Axial oscillation with material damping";
  chart.x_label = "time / s";
  chart.y_label = "elongation / m";
  const double h = 0.005;
  for (double zeta : {0.01, 0.1, 0.5}) {
    const double gamma = zeta * kOmega, wd = kOmega * std::sqrt(1.0 - zeta * zeta);
    for (Method method : kMethods) {
      const std::vector<double> q = elongation(context, method, zeta, h, 240);
      const std::complex<double> s = measured_exponent(q, method, h, 2.0 * kPi / wd);
      const std::string what = fmt::format("damping ratio {}, {}", zeta, to_string(method));
      constexpr const char* kExact =
          "the law is linear along the thread and the scheme's warping taken out exactly: "
          "round-off";
      context.relative("rate of decay, " + what, "1/s", -s.real(), gamma, 1e-7, kExact);
      context.relative("frequency, " + what, "rad/s", s.imag(), wd, 1e-8, kExact);
    }
    if (zeta == 0.01) continue;
    const std::vector<double> q = elongation(context, Method::midpoint, zeta, h, 240);
    Curve ours{fmt::format("damping ratio {}, midpoint", zeta), {}, {}, CurveStyle::line};
    Curve exact{fmt::format("exact, {}", zeta), {}, {}, CurveStyle::dashed};
    for (std::size_t k = 0; k < q.size(); ++k) {
      const double t = h * static_cast<double>(k);
      ours.x.push_back(t);
      ours.y.push_back(q[k]);
      exact.x.push_back(t);
      exact.y.push_back(std::exp(-gamma * t) * std::sin(wd * t) / wd);
    }
    chart.curves.push_back(ours);
    chart.curves.push_back(exact);
  }
  chart.caption =
      "Two masses of 1 kg on 1 m of thread, 20 rad/s undamped, tau = 2 zeta / omega; h = 5 ms.";
  chart.source = "exact: exp(-zeta omega t) sin(omega_d t) / omega_d";
  context.chart(chart);
}

// Falls with damping mu, starting at v0 (m/s) along gravity g; the velocity at every step.
std::vector<double> fall(Context& context, Method method, double mu, double g, double v0, double h,
                         int steps) {
  Network net = straight_line(2, 1.0, plain_thread(100.0, 0.1));
  for (Vec3& v : net.velocity) v.z() = -v0;
  Simulation sim = context.simulation(net, kNoBodies);
  sim.configure({{0, 0, -g}, mu}, with(method, h, 1e-12), {});
  std::vector<double> result{v0};
  advance(sim, h, steps, {}, [&](int) { result.push_back(-sim.state().v[1].z()); });
  return result;
}

void compare_environment(Context& context) {
  const double mu = 2.0, g = 9.81, h = 0.05;
  const int steps = 300;
  Chart chart;
  chart.title = "Fall with environmental damping";
  chart.x_label = "time / s";
  chart.y_label = "velocity / m/s";
  for (Method method : kMethods) {
    const bool first = method == Method::implicit_euler;
    const std::vector<double> v = fall(context, method, mu, g, 0.0, h, steps);
    double wanted = 0.0, worst = 0.0;
    for (int k = 1; k <= steps; ++k) {
      wanted = first ? (wanted + h * g) / (1.0 + mu * h)
                     : (wanted * (1.0 - 0.5 * mu * h) + h * g) / (1.0 + 0.5 * mu * h);
      worst = std::max(worst, std::abs(v[static_cast<std::size_t>(k)] / wanted - 1.0));
    }
    const std::string name = to_string(method);
    context.absolute("difference of falling velocities over the velocity, " + name, "1", worst, 0.0,
                     1e-11, "the scheme's own recursion: round-off",
                     first ? "exact: v1 = (v0 + h g) / (1 + mu h)"
                           : "exact: v1 = (v0 (1 - mu h/2) + h g) / (1 + mu h/2)");
    context.relative("terminal velocity, " + name, "m/s", v.back(), g / mu, 1e-11,
                     "exp(-30) after 15 s", "exact: g / mu");
    const std::vector<double> free = fall(context, method, mu, 0.0, 3.0, h, steps);
    std::vector<double> start(free.begin(), free.begin() + 41);
    const double z = start[40] / start[0];
    const double rate =
        first ? (1.0 - std::pow(z, -1.0 / 40)) / h
              : 2.0 / h * (std::pow(z, 1.0 / 40) - 1.0) / (std::pow(z, 1.0 / 40) + 1.0);
    context.relative("decay of free flight, " + name, "1/s", -rate, mu, 1e-11,
                     "the scheme's warping taken out exactly: round-off", "exact: mu");
    if (method == Method::newmark) continue;
    Curve curve{name + ", h = 50 ms", {}, {}, CurveStyle::line};
    for (int k = 0; k <= 60; ++k) {
      curve.x.push_back(k * h);
      curve.y.push_back(v[static_cast<std::size_t>(k)]);
    }
    chart.curves.push_back(curve);
  }
  Curve exact{"exact", {}, {}, CurveStyle::dashed};
  for (int k = 0; k <= 120; ++k) {
    exact.x.push_back(0.025 * k);
    exact.y.push_back(g / mu * -std::expm1(-mu * 0.025 * k));
  }
  chart.curves.push_back(exact);
  chart.caption = "A free thread falls under 9.81 m/s2 with mu = 2 1/s.";
  chart.source = "exact: g/mu (1 - exp(-mu t))";
  context.chart(chart);
  // The continuum by its order.
  const auto off = [&](Method method, int n) {
    return fall(context, method, mu, g, 0.0, 1.0 / n, n).back() - g / mu * -std::expm1(-mu);
  };
  for (Method method : kMethods) {
    const bool first = method == Method::implicit_euler;
    context.absolute(fmt::format("order of the velocity after 1 s, {}", to_string(method)), "1",
                     std::log2(off(method, 100) / off(method, 200)), first ? 1.0 : 2.0, 0.02,
                     "the scheme's order", "theory of the scheme");
  }
}

void run(Context& context) {
  compare_material(context);
  compare_environment(context);
}

}  // namespace

Case material_damping_case() {
  Case c;
  c.name = "material-damping";
  c.title = "Material and environmental damping";
  c.group = Group::dynamics;
  c.about =
      "Two masses on a thread with Kelvin-Voigt damping swing along it at damping ratios 0.01, 0.1 "
      "and 0.5; a free thread falls and flies with environmental damping. Compared, for each "
      "integrator: rate of decay and frequency with the closed form, terminal velocity g/mu, and "
      "the scheme's own recursion.";
  c.source = "exact: zeta omega, omega sqrt(1 - zeta^2)";
  c.guards = {"stretching", "gravity", "environment damping", "material damping", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

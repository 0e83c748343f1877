// Flat square nets under tension: sag under a load, and frequencies.
#include "verification/framework/case.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "verification/framework/equilibrium.hpp"
#include "verification/framework/line.hpp"
#include "verification/framework/swing.hpp"

namespace retiarius::verification {

namespace {

constexpr double kRest = 1.0, kSpacing = 1.25;  // m
constexpr double kAxial = 100.0;                // EA, N
constexpr double kTension = kAxial * (kSpacing / kRest - 1.0);
constexpr double kMass = 0.4;  // of each knot, kg

// cells x cells meshes, stretched by a quarter.
Network tight_net(int cells) {
  NetSpec spec;
  spec.pattern = Pattern::square;
  spec.side = cells * kRest;
  spec.mesh = kRest;
  spec.thread.young_modulus = kAxial / (kPi * 1e-6);
  spec.thread.density = 1000.0;
  spec.thread.radius = 1e-3;
  spec.scale = kSpacing / kRest;
  Network net = build_network(spec);
  std::fill(net.mass.begin(), net.mass.end(), kMass);
  return net;
}

void compare_sag(Context& context) {
  const std::pair<int, double> wanted[] = {{2, 1.0 / 4.0}, {4, 3.0 / 8.0}, {6, 23.0 / 52.0}};
  for (const auto& [cells, exact] : wanted) {
    Network net = tight_net(cells);
    const Index center = net.center;
    const double load = 4e-4 * kTension;
    load_only(net, center, load);
    const State s = equilibrium(context, net, {0, 0, -1}, net.perimeter);
    context.relative(
        fmt::format("sag under a load at the centre, {0} x {0} free knots, w T / (P a)", cells - 1),
        "1", -s.x[center].z() * kTension / (load * kSpacing), exact, 1e-6,
        "slopes of 1e-4 stiffen by (EA / T) times their square; the knots' own weight is 1e-12");
  }
}

// Swings in mode (p, q) of the interior n x n knots; the square of the frequency, 1/s2.
double observed(const Context& context, int cells, int p, int q, Curve* swing) {
  Network net = tight_net(cells);
  const double half = 0.5 * cells * kSpacing;
  Index loudest = 0;
  for (Index i = 0; i < net.node_count(); ++i) {
    Vec3& x = net.initial[i];
    x.z() = 1e-5 * std::sin(p * kPi * (x.x() + half) / (2.0 * half)) *
            std::sin(q * kPi * (x.y() + half) / (2.0 * half));
    if (x.z() > net.initial[loudest].z()) loudest = i;
  }
  std::vector<Prescribed> edge = held(net, net.perimeter);
  std::sort(edge.begin(), edge.end(),
            [](const Prescribed& a, const Prescribed& b) { return a.node < b.node; });
  for (Prescribed& at : edge) at.position.z() = 0.0;
  const std::vector<Body> none;
  Simulation simulation = context.simulation(net, none);
  constexpr double kStep = 0.02;
  simulation.configure({}, with(Method::newmark, kStep, 1e-10), {});
  std::vector<double> z = {net.initial[loudest].z()};
  advance(simulation, kStep, 60, edge,
          [&](int) { z.push_back(simulation.state().x[loudest].z()); });
  if (swing) {
    for (std::size_t k = 0; k < z.size(); ++k) {
      swing->x.push_back(kStep * static_cast<double>(k));
      swing->y.push_back(z[k] / z[0]);
    }
  }
  return squared_frequency(z, kStep);
}

double exact_square(int cells, int p, int q) {
  return 2.0 * kTension / (kMass * kSpacing) *
         (2.0 - std::cos(p * kPi / cells) - std::cos(q * kPi / cells));
}

void compare_frequencies(Context& context) {
  Chart chart;
  chart.title = "Pretensioned square nets swing in their modes";
  chart.x_label = "time / s";
  chart.y_label = "amplitude / 1";
  const int modes[][3] = {{2, 1, 1}, {4, 1, 1}, {6, 1, 1}, {6, 2, 1}, {6, 2, 2}};
  for (const auto& [cells, p, q] : modes) {
    const bool drawn = cells == 6;
    Curve ours{fmt::format("mode {}, {}", p, q), {}, {}};
    const double square = observed(context, cells, p, q, drawn ? &ours : nullptr);
    const double exact = exact_square(cells, p, q);
    context.relative(fmt::format("frequency, {0} x {0} free knots, mode {1}, {2}", cells - 1, p, q),
                     "1/s", std::sqrt(square) / (2.0 * kPi), std::sqrt(exact) / (2.0 * kPi), 1e-7,
                     "slopes of 1e-5 stiffen by (EA / T) times their square; round-off",
                     "exact eigenvalues of the lattice");
    if (!drawn) continue;
    Curve wanted{fmt::format("exact {}, {}", p, q), {}, {}, CurveStyle::points};
    for (std::size_t k = 0; k < ours.x.size(); k += 4) {
      wanted.x.push_back(ours.x[k]);
      wanted.y.push_back(std::cos(std::sqrt(exact) * ours.x[k]));
    }
    chart.curves.push_back(ours);
    chart.curves.push_back(wanted);
  }
  chart.caption =
      "5 x 5 free knots of 0.4 kg, 1.25 m apart, T = 25 N in every segment, fixed edge; Newmark, "
      "h = 0.02 s.";
  chart.source = "exact eigenvalues of the lattice";
  context.chart(chart);
}

void run(Context& context) {
  compare_sag(context);
  compare_frequencies(context);
}

}  // namespace

Case pretensioned_net_case() {
  Case c;
  c.name = "pretensioned-net";
  c.title = "Flat pretensioned nets: sag and frequencies";
  c.group = Group::cables;
  c.about =
      "Flat square nets stretched by a quarter (EA 100 N, T 25 N, spacing 1.25 m), edge fixed. "
      "Compared: the sag of the middle under a small load, w T / (P a) = 1/4, 3/8, 23/52 for 1, 9 "
      "and 25 free knots; and the frequencies of modes of small amplitude, omega^2 = 2 T / (m a) "
      "(2 - cos(p pi / n) - cos(q pi / n)), the integrator's own shift taken out.";
  c.source = "exact solution of the lattice";
  c.guards = {"stretching", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

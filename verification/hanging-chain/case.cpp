// Small swings of a chain that hangs from its end.
#include "verification/framework/case.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "verification/framework/line.hpp"
#include "verification/framework/oscillation.hpp"

namespace retiarius::verification {

namespace {

constexpr double kLength = 1.0;  // m
constexpr double kGravity = 9.81;
constexpr double kLine = 0.01;                                   // kg/m
constexpr double kStiffness = 1e5 * kLine * kGravity * kLength;  // EA, N
constexpr double kContinuum[] = {0.5 * 2.404825557695773, 0.5 * 5.520078110286311,
                                 0.5 * 8.653727912911013};

// Hanging at rest, stretched by its weight: places as they are, rest lengths as they were.
Network hanging(int segments, double stiffness) {
  Network net = straight_line(segments, kLength, plain_thread(stiffness, kLine), -Vec3::UnitZ());
  double below = 0.0;  // weight, N
  for (double m : net.mass) below += m * kGravity;
  for (Index k = 0; k < segments; ++k) {
    below -= net.mass[k] * kGravity;
    const double length = net.segments[k].rest_length * (1.0 + below / stiffness);
    net.initial[k + 1] = net.initial[k] - length * Vec3::UnitZ();
  }
  return net;
}

struct Modes {
  Eigen::MatrixXd shapes;       // of the nodes below the held one, one column a mode
  Eigen::VectorXd frequencies;  // rad/s
};

// Of the discrete chain: each segment resists a sideways step by its tension over its length.
Modes modes(const Network& net) {
  const Index n = net.node_count() - 1;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd mass(n);
  double below = 0.0;
  for (Index k = n; k >= 1; --k) {
    mass[k - 1] = net.mass[k];
    below += net.mass[k] * kGravity;
    const double across = below / (net.initial[k] - net.initial[k - 1]).norm();
    stiffness(k - 1, k - 1) += across;
    if (k == 1) continue;
    stiffness(k - 2, k - 2) += across;
    stiffness(k - 1, k - 2) -= across;
    stiffness(k - 2, k - 1) -= across;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness,
                                                                         mass.asDiagonal());
  return {solver.eigenvectors(), solver.eigenvalues().cwiseSqrt()};
}

// rad/s, of mode `mode` of the simulated chain, started by its velocities.
double measured(Context& context, int segments, int mode, double stiffness) {
  Network net = hanging(segments, stiffness);
  const Modes m = modes(net);
  const double omega = m.frequencies[mode];
  const Eigen::VectorXd shape = m.shapes.col(mode) / m.shapes.col(mode).cwiseAbs().maxCoeff();
  for (Index k = 1; k <= segments; ++k)
    net.velocity[k].x() = 1e-4 * kLength / segments * omega * shape[k - 1];
  Simulation sim = context.simulation(net, kNoBodies);
  const double period = 2.0 * kPi / omega, h = period / 80;
  sim.configure({{0, 0, -kGravity}, 0.0}, with(Method::midpoint, h, 1e-12), {});
  std::vector<double> end{0.0};
  advance(sim, h, 160, held(net, {0}), [&](int) { end.push_back(sim.state().x.back().x()); });
  return measured_exponent(end, Method::midpoint, h, period).imag();
}

void compare(Context& context, int mode, const std::vector<int>& sizes, Chart& chart) {
  const double unit = std::sqrt(kGravity / kLength);
  std::vector<double> ours;
  Curve curve{fmt::format("mode {}", mode + 1), {}, {}, CurveStyle::line};
  for (int n : sizes) {
    const double stiff = measured(context, n, mode, kStiffness) / unit;
    const double soft = measured(context, n, mode, 0.5 * kStiffness) / unit;
    ours.push_back(2.0 * stiff - soft);
    context.relative(fmt::format("omega_{} sqrt(L/g), {} segments", mode + 1, n), "1", stiff,
                     modes(hanging(n, kStiffness)).frequencies[mode] / unit, 1e-6,
                     "the midpoint rule's warping taken out exactly; swings of 1e-4 of a segment",
                     "eigenvalue of the discrete chain");
    curve.x.push_back(n);
    curve.y.push_back(std::abs(ours.back() / kContinuum[mode] - 1.0));
  }
  const std::size_t last = ours.size() - 1;
  context.absolute(fmt::format("order in the segments' length, mode {}", mode + 1), "1",
                   std::log2((ours[last - 2] - ours[last - 1]) / (ours[last - 1] - ours[last])),
                   2.0, 0.03,
                   "linear elements with lumped masses: second order; the next is the fourth");
  context.relative(
      fmt::format("omega_{} sqrt(L/g), extrapolated", mode + 1), "1",
      (4.0 * ours[last] - ours[last - 1]) / 3.0, kContinuum[mode], 1e-5,
      "after the second order the third follows, from the tip, where the tension vanishes");
  chart.curves.push_back(curve);
}

void run(Context& context) {
  const std::vector<int> sizes = {20, 40, 80, 160};
  Chart chart;
  chart.title = "Frequencies of a hanging chain";
  chart.x_label = "segments";
  chart.y_label = "relative difference to the continuum";
  chart.log_x = chart.log_y = true;
  for (int mode = 0; mode < 3; ++mode) compare(context, mode, sizes, chart);
  Curve slope{"order 2", {}, {}, CurveStyle::dashed};
  for (int n : sizes) {
    slope.x.push_back(n);
    slope.y.push_back(0.5 * chart.curves[0].y[0] * std::pow(1.0 * sizes[0] / n, 2));
  }
  chart.curves.push_back(slope);
  chart.caption =
      "Chain of 1 m, EA = 1e5 of its weight and extrapolated to infinity, midpoint rule; omega_n = "
      "(j_0n / 2) sqrt(g/L), j_0n the zeros of the Bessel function J0.";
  chart.source = "exact frequencies of the inextensible chain";
  context.chart(chart);
}

}  // namespace

Case hanging_chain_case() {
  Case c;
  c.name = "hanging-chain";
  c.title = "Frequencies of a hanging chain";
  c.group = Group::dynamics;
  c.about =
      "A thread of 1 m without bending hangs from its end under 9.81 m/s2 and swings in each of "
      "its first three modes. Compared: the frequency in the simulation with the eigenvalue of the "
      "discrete chain, and with the continuum's (j_0n / 2) sqrt(g/L) by its order.";
  c.source = "exact: (j_0n / 2) sqrt(g / L)";
  c.guards = {"stretching", "gravity", "mass"};
  c.run = run;
  return c;
}

}  // namespace retiarius::verification

#include "verification/framework/equilibrium.hpp"

#include <cmath>

#include "verification/framework/line.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

State equilibrium(const Context& context, Network net, const Vec3& gravity,
                  const std::vector<Index>& held_nodes, double tolerance) {
  const std::vector<Body> none;
  Simulation simulation = context.simulation(net, none);
  IntegratorSpec spec = with(Method::static_solve, 0.01, tolerance);
  spec.max_iterations = 500;
  simulation.configure({gravity, 0.0}, spec, {});
  simulation.solve_static(held(net, held_nodes));
  return simulation.state();
}

void load_only(Network& net, Index node, double load) {
  for (double& m : net.mass) m = 1e-12 * load;
  net.mass[node] = load;
}

void lay_on_arc(Network& net, double span) {
  double length = 0.0;
  for (const Segment& e : net.segments) length += e.rest_length;
  // Half the arc's angle from chord / arc.
  const double half =
      bisect([&](double q) { return std::sin(q) / q - span / length; }, 1e-6, 1.01 * kPi);
  const double radius = 0.5 * length / half;
  double s = 0.0;
  for (Index k = 0; k < net.node_count(); ++k) {
    const double angle = half * (2.0 * s / length - 1.0);
    net.initial[k] = {radius * std::sin(angle) + 0.5 * span, 0.0,
                      radius * (std::cos(half) - std::cos(angle))};
    if (k < net.segment_count()) s += net.segments[k].rest_length;
  }
  // To the last digit: what is held is compared with.
  net.initial.front() = Vec3::Zero();
  net.initial.back() = {span, 0.0, 0.0};
}

}  // namespace retiarius::verification

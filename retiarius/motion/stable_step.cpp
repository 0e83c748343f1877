#include "retiarius/motion/stable_step.hpp"

#include <cmath>

namespace retiarius {

namespace {

// What each node feels: stiffness, N/m, and viscosity, N s/m.
struct Stiffness {
  std::vector<double> elastic, viscous;
};

void add_bending(const Network& network, Stiffness& sum) {
  for (const Joint& j : network.joints) {
    const double first = 1.0 / network.segments[j.first].rest_length;
    const double second = 1.0 / network.segments[j.second].rest_length;
    // |c_a| + |c_b| + |c_c| of the difference of slopes, and Gershgorin's half.
    const double k = j.bending_stiffness / j.voronoi_length * 0.5 * 2.0 * (first + second);
    sum.elastic[j.a] += k * first;
    sum.elastic[j.b] += k * (first + second);
    sum.elastic[j.c] += k * second;
  }
}

}  // namespace

StableStep stable_explicit_step(const Network& network) {
  Stiffness sum{std::vector<double>(network.mass.size(), 0.0),
                std::vector<double>(network.mass.size(), 0.0)};
  for (const Segment& s : network.segments) {
    const Material& m = network.materials[s.material];
    const double k = m.axial_stiffness / s.rest_length;
    for (const Index node : {s.a, s.b}) {
      sum.elastic[node] += k;
      sum.viscous[node] += k * m.damping;
    }
  }
  add_bending(network, sum);
  const auto stable = [&](Index node) {
    const double a = 2.0 * sum.elastic[node] / network.mass[node];
    const double b = 2.0 * sum.viscous[node] / network.mass[node];
    return 2.0 * (std::sqrt(b * b + a) - b) / a;
  };
  StableStep result{kInfinity, kNone};
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& s = network.segments[i];
    const double step = std::min(stable(s.a), stable(s.b));
    if (step < result.step) result = {step, static_cast<Index>(i)};
  }
  return result;
}

}  // namespace retiarius

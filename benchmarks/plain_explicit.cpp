#include "benchmarks/plain_explicit.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius::benchmarks {

PlainExplicit::PlainExplicit(const Network& network)
    : x(network.initial),
      v(network.velocity),
      mass_(network.mass),
      force_(network.mass.size(), Vec3::Zero()) {
  for (const Segment& s : network.segments) {
    const Material& m = network.materials[s.material];
    springs_.push_back(
        {s.a, s.b, s.rest_length, m.axial_stiffness / s.rest_length, m.damping, m.compression});
  }
}

double PlainExplicit::stable_step() const {
  std::vector<double> elastic(mass_.size(), 0.0), viscous(mass_.size(), 0.0);
  for (const Spring& s : springs_) {
    for (const Index node : {s.a, s.b}) {
      elastic[node] += s.stiffness;
      viscous[node] += s.stiffness * s.damping;
    }
  }
  double least = kInfinity;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    if (elastic[i] == 0.0) continue;
    const double tau = viscous[i] / elastic[i];
    least = std::min(least, std::sqrt(tau * tau + 2.0 * mass_[i] / elastic[i]) - tau);
  }
  return least;
}

void PlainExplicit::step(double h) {
  std::fill(force_.begin(), force_.end(), Vec3::Zero());
  for (const Spring& s : springs_) {
    const Vec3 d = x[s.b] - x[s.a];
    const double length = d.norm();
    if (length <= s.rest && !s.compression) continue;
    const Vec3 t = d / length;
    const double rate = t.dot(v[s.b] - v[s.a]);
    const Vec3 f = s.stiffness * (length - s.rest + s.damping * rate) * t;
    force_[s.a] += f;
    force_[s.b] -= f;
  }
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    v[i] += h / mass_[i] * force_[i];
    x[i] += h * v[i];
  }
}

}  // namespace retiarius::benchmarks

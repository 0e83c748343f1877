#include "retiarius/measure/momentum.hpp"

#include <algorithm>

#include "retiarius/measure/energy.hpp"

namespace retiarius {

double total_mass(const Network& network, const std::vector<Body>& bodies) {
  double sum = 0.0;
  for (const double m : network.mass) sum += m;
  for (const Body& b : bodies)
    if (!b.fixed) sum += b.mass;
  return sum;
}

Vec3 mass_center(const Network& network, const std::vector<Body>& bodies, const State& state) {
  return first_moment(network, bodies, state) / total_mass(network, bodies);
}

Vec3 linear_momentum(const Network& network, const std::vector<Body>& bodies, const State& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < state.v.size(); ++i) sum += network.mass[i] * state.v[i];
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (!bodies[b].fixed) sum += bodies[b].mass * state.bodies[b].velocity;
  return sum;
}

Vec3 angular_momentum(const Network& network, const std::vector<Body>& bodies, const State& state,
                      const Vec3& about) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < state.v.size(); ++i)
    sum += network.mass[i] * (state.x[i] - about).cross(state.v[i]);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].fixed) continue;
    const BodyState& s = state.bodies[b];
    sum += bodies[b].mass * (s.position - about).cross(s.velocity) + s.angular_momentum;
  }
  return sum;
}

double linear_scale(const Network& network, const std::vector<Body>& bodies, const State& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.v.size(); ++i) sum += network.mass[i] * state.v[i].norm();
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (!bodies[b].fixed) sum += bodies[b].mass * state.bodies[b].velocity.norm();
  return sum;
}

double angular_scale(const Network& network, const std::vector<Body>& bodies, const State& state) {
  const Vec3 c = mass_center(network, bodies, state);
  const Vec3 vc = linear_momentum(network, bodies, state) / total_mass(network, bodies);
  double sum = 0.0;
  for (std::size_t i = 0; i < state.v.size(); ++i)
    sum += network.mass[i] * (state.x[i] - c).norm() * (state.v[i] - vc).norm();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].fixed) continue;
    const BodyState& s = state.bodies[b];
    sum += bodies[b].mass * (s.position - c).norm() * (s.velocity - vc).norm() +
           s.angular_momentum.norm();
  }
  return sum;
}

void MomentumDrift::add(const Vec3& momentum, const Vec3& impulse, double scale) {
  largest_ = std::max(largest_, (momentum - impulse - base_).norm());
  scale_ = std::max(scale_, scale);
}

std::optional<double> MomentumDrift::value() const {
  if (scale_ == 0.0) return std::nullopt;
  return largest_ / scale_;
}

}  // namespace retiarius

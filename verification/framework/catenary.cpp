#include "verification/framework/catenary.hpp"

#include <cmath>

#include "verification/framework/roots.hpp"

namespace retiarius::verification {

using Eigen::Vector2d;

Catenary catenary(double span) {
  const double pull =
      bisect([span](double h) { return 2.0 * h * std::asinh(0.5 / h) - span; }, 1e-9, 1e6);
  const double tension = std::hypot(pull, 0.5);
  return {tension - pull, pull, tension};
}

Vector2d ElasticCable::point(double pull, double lift, double s) const {
  const double up = weight * s - lift;
  const double x =
      pull * s / stiffness + pull / weight * (std::asinh(up / pull) + std::asinh(lift / pull));
  const double y = (0.5 * weight * s - lift) * s / stiffness +
                   (std::hypot(pull, up) - std::hypot(pull, lift)) / weight;
  return {x, y};
}

namespace {

// Irvine's start for the iteration: a parabola of the same length.
Vector2d first_guess(const ElasticCable& cable, const Vector2d& far) {
  const double slack = (cable.length * cable.length - far.y() * far.y()) / (far.x() * far.x());
  const double lambda = slack > 1.01 ? std::sqrt(3.0 * (slack - 1.0)) : 0.2;
  return {0.5 * cable.weight * far.x() / lambda,
          0.5 * cable.weight * (cable.length - far.y() / std::tanh(lambda))};
}

}  // namespace

Vector2d end_forces(const ElasticCable& cable, const Vector2d& far) {
  return newton([&](const Vector2d& f) -> Vector2d { return cable.end(f[0], f[1]) - far; },
                first_guess(cable, far));
}

Vector2d end_forces(const ElasticCable& cable, const Vector2d& far, double load, double s) {
  Vector2d forces = end_forces(cable, far);
  ElasticCable rest = cable;
  rest.length = cable.length - s;
  constexpr int kParts = 20;  // in which the load comes, each starting where the last one ended
  for (int k = 1; k <= kParts; ++k) {
    const auto miss = [&](const Vector2d& f) -> Vector2d {
      const double lift = f[1] - cable.weight * s - load * k / kParts;
      return cable.point(f[0], f[1], s) + rest.end(f[0], lift) - far;
    };
    forces = newton(miss, forces);
  }
  return forces;
}

Chain chain(int segments, double span) {
  const double n = segments;
  const auto rise = [n](int k) { return (k + 0.5 - 0.5 * n) / n; };
  const auto reach = [&](double pull) {
    double x = 0.0;
    for (int k = 0; k < segments; ++k) x += pull / (n * std::hypot(pull, rise(k)));
    return x - span;
  };
  Chain result;
  result.pull = bisect(reach, 1e-9, 1e6);
  result.nodes = {Vector2d::Zero()};
  for (int k = 0; k < segments; ++k) {
    const Vector2d force(result.pull, rise(k));
    result.nodes.push_back(result.nodes.back() + force / (n * force.norm()));
  }
  return result;
}

}  // namespace retiarius::verification

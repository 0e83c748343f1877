#include "verification/framework/elastica.hpp"

#include <cmath>

#include <Eigen/Core>

#include "retiarius/base/vec.hpp"
#include "verification/framework/roots.hpp"

namespace retiarius::verification {

namespace {

using State4 = Eigen::Vector4d;  // x, y, angle, curvature

State4 slope(const ElasticLine& line, double s, const State4& u) {
  const double c = std::cos(u[2]), d = std::sin(u[2]);
  const double up = line.lift + line.weight * s;
  const double stretch = 1.0 + line.flexibility * (line.pull * c + up * d);
  return {stretch * c, stretch * d, u[3], stretch * (line.pull * d - up * c)};
}

// The half of a hanging line to the right of its middle, and by how much it misses span and moment.
std::vector<Station> right_half(double weight, double pull, double curvature) {
  ElasticLine line;
  line.pull = pull;
  line.weight = weight;
  Station middle;
  middle.curvature = curvature;
  return integrate(line, middle, 0.5);
}

}  // namespace

std::vector<Station> integrate(const ElasticLine& line, const Station& from, double to, int steps) {
  const double h = (to - from.s) / steps;
  State4 u(from.x, from.y, from.angle, from.curvature);
  std::vector<Station> result = {from};
  for (int k = 0; k < steps; ++k) {
    const double s = from.s + k * h;
    const State4 k1 = slope(line, s, u);
    const State4 k2 = slope(line, s + 0.5 * h, u + 0.5 * h * k1);
    const State4 k3 = slope(line, s + 0.5 * h, u + 0.5 * h * k2);
    const State4 k4 = slope(line, s + h, u + h * k3);
    u += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    result.push_back({from.s + (k + 1) * h, u[0], u[1], u[2], u[3]});
  }
  return result;
}

std::vector<Station> cantilever(double weight, double tip_load, double flexibility) {
  ElasticLine line;
  line.flexibility = flexibility;
  line.lift = -tip_load - weight;
  line.weight = weight;
  const auto from_tip = [&](double angle) {
    Station tip;
    tip.s = 1.0;
    tip.angle = angle;
    return integrate(line, tip, 0.0);
  };
  const double angle = bisect([&](double a) { return from_tip(a).back().angle; }, -0.5 * kPi, 0.0);
  std::vector<Station> back = from_tip(angle);
  const Station clamp = back.back();
  std::vector<Station> result(back.rbegin(), back.rend());
  for (Station& p : result) {
    p.x -= clamp.x;
    p.y -= clamp.y;
  }
  return result;
}

Elastica elastica(double k) {
  const double first = std::comp_ellint_1(k), second = std::comp_ellint_2(k);
  return {std::pow(2.0 * first / kPi, 2), 2.0 * second / first - 1.0, k / first};
}

std::vector<HangingLine> hanging_lines(double span, const std::vector<double>& weights) {
  const double k = bisect([&](double q) { return elastica(q).span - span; }, 1e-6, 0.9089);
  const double load = kPi * kPi * elastica(k).load;
  Eigen::Vector2d unknown(-load, 2.0 * k * std::sqrt(load));  // pull, curvature of the middle
  const auto solve = [&](double weight) {
    const Plane misses = [&](const Eigen::Vector2d& u) {
      const Station end = right_half(weight, u[0], u[1]).back();
      return Eigen::Vector2d(end.x - 0.5 * span, end.curvature);
    };
    unknown = newton(misses, unknown);
  };
  std::vector<HangingLine> result;
  double reached = 0.0;
  for (double weight : weights) {
    while (reached < weight) {
      reached = std::min(weight, std::max(1.15 * reached, 2.0));
      solve(reached);
    }
    HangingLine line;
    line.pull = unknown[0];
    line.half = right_half(weight, unknown[0], unknown[1]);
    line.sag = line.half.back().y;
    result.push_back(line);
  }
  return result;
}

double midpoint_deflection(double load, double flexibility) {
  ElasticLine line;
  line.flexibility = flexibility;
  Eigen::Vector2d unknown(0.0, 0.0);  // pull, angle at the pinned end
  const auto half = [&](const Eigen::Vector2d& u) {
    line.pull = u[0];
    Station end;
    end.angle = u[1];
    return integrate(line, end, 0.5).back();
  };
  // Followed from a small load, where the line is a beam, along powers of the load.
  double reached = std::min(load, 1.0), growth = 1.0;
  unknown[1] = -reached / 16.0;
  Eigen::Vector2d before = unknown;
  for (;;) {
    line.lift = -0.5 * reached;
    const Eigen::Vector2d found = newton(
        [&](const Eigen::Vector2d& u) {
          const Station middle = half(u);
          return Eigen::Vector2d(middle.x - 0.5, middle.angle);
        },
        unknown);
    if (reached >= load) {
      unknown = found;
      break;
    }
    const double next = std::min(load, 1.2 * reached);
    const double part = growth > 1.0 ? std::log(next / reached) / std::log(growth) : 0.0;
    unknown = found + part * (found - before);
    before = found;
    growth = next / reached;
    reached = next;
  }
  return -half(unknown).y;
}

}  // namespace retiarius::verification

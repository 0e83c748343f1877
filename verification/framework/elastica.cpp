#include "verification/framework/elastica.hpp"

#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "retiarius/base/vec.hpp"
#include "verification/framework/catenary.hpp"
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

// The half of a hanging line to the right of its middle, as far as it is of use.
std::vector<Station> right_half(const ElasticLine& line, double curvature) {
  Station middle;
  middle.curvature = curvature;
  return integrate(line, middle, 0.5, 500, true);
}

// The half without moment at its end. With too small a curvature of the middle the line is straight
// before its end, with too large a one it winds up.
std::vector<Station> free_half(double pull, double weight, double flexibility) {
  ElasticLine line;
  line.pull = pull;
  line.weight = weight;
  line.flexibility = flexibility;
  const double most = 20.0 + 4.0 * std::cbrt(weight);
  const double curvature =
      bisect([&](double k) { return right_half(line, k).back().curvature; }, 1e-12, most);
  return integrate(line, {0.0, 0.0, 0.0, 0.0, curvature}, 0.5, 500);
}

HangingLine hanging(double pull, std::vector<Station> half) {
  HangingLine line;
  line.pull = pull;
  line.sag = half.back().y;
  line.half = std::move(half);
  return line;
}

}  // namespace

std::vector<Station> integrate(const ElasticLine& line, const Station& from, double to, int steps,
                               bool until_decided) {
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
    if (until_decided && (u[3] < 0.0 || u[2] > kPi)) break;
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

HangingLine hanging_line(double span, double weight, double flexibility) {
  const auto miss = [&](double pull) {
    return free_half(pull, weight, flexibility).back().x - 0.5 * span;
  };
  // From more push than any elastica bears to more pull than a catenary's.
  const double pull =
      root(miss, -30.0 - std::cbrt(weight * weight), 1.0 + 2.0 * weight * catenary(span).pull);
  return hanging(pull, free_half(pull, weight, flexibility));
}

HangingLine free_hanging_line(double weight, double flexibility) {
  return hanging(0.0, free_half(0.0, weight, flexibility));
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

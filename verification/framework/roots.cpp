#include "verification/framework/roots.hpp"

#include <cmath>

#include <Eigen/LU>

#include "retiarius/base/error.hpp"

namespace retiarius::verification {

double bisect(const std::function<double(double)>& f, double a, double b) {
  double fa = f(a);
  if (fa == 0.0) return a;
  if (std::signbit(fa) == std::signbit(f(b))) throw Error("bisect: no change of sign");
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (a + b);
    if (middle == a || middle == b) break;
    const double fm = f(middle);
    if (std::signbit(fm) == std::signbit(fa)) {
      a = middle;
      fa = fm;
    } else {
      b = middle;
    }
  }
  return 0.5 * (a + b);
}

double root(const std::function<double(double)>& f, double a, double b) {
  const double close = 1e-13 * std::abs(b - a);
  double fa = f(a), fb = f(b);
  if (std::signbit(fa) == std::signbit(fb)) throw Error("root: no change of sign");
  for (int k = 0; k < 200 && std::abs(b - a) > close && fb != 0.0; ++k) {
    const double c = k % 8 == 7 ? 0.5 * (a + b) : b - fb * (b - a) / (fb - fa);
    const double fc = f(c);
    if (std::abs(c - b) <= close) return c;
    if (std::signbit(fc) != std::signbit(fb)) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = c;
    fb = fc;
  }
  return b;
}

Eigen::Vector2d newton(const Plane& f, Eigen::Vector2d x) {
  Eigen::Vector2d r = f(x);
  for (int k = 0; k < 60; ++k) {
    Eigen::Matrix2d slope;
    for (int j = 0; j < 2; ++j) {
      const double d = 1e-6 * std::max(1e-3, std::abs(x[j]));
      Eigen::Vector2d up = x, down = x;
      up[j] += d;
      down[j] -= d;
      slope.col(j) = (f(up) - f(down)) / (2.0 * d);
    }
    const Eigen::Vector2d step = -slope.inverse() * r;
    double part = 1.0;
    Eigen::Vector2d next = f(x + step);
    while (!(next.norm() < r.norm()) && part > 1e-4) {
      part *= 0.5;
      next = f(x + part * step);
    }
    // No progress: either at the level of round-off, or lost.
    if (!(next.norm() < r.norm())) break;
    x += part * step;
    r = next;
  }
  if (!(r.norm() < 1e-8)) throw Error("newton: the two equations were not solved");
  return x;
}

double observed_order(double coarse_error, double fine_error) {
  return std::log2(std::abs(coarse_error / fine_error));
}

double extrapolated(double coarse, double fine, double order) {
  return fine + (fine - coarse) / (std::exp2(order) - 1.0);
}

}  // namespace retiarius::verification

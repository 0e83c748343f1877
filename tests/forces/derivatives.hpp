// Compares a law's gradient and Hessian with finite differences of its potential and gradient.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include "retiarius/state/law.hpp"

namespace retiarius::testing {

inline std::vector<Vec3> gradient_of(const Law& law, const Step& step, const std::vector<Vec3>& y) {
  std::vector<Vec3> g(y.size(), Vec3::Zero());
  Assembly out{&g, nullptr, false};
  law.assemble(step, y, out);
  return g;
}

// An empty Hessian of the law's own pattern, which is made here and must outlive it; the law is
// bound to that pattern.
inline BlockMatrix empty_hessian(Law& law, BlockPattern& pattern) {
  law.couple(pattern);
  pattern.finish();
  law.bind(pattern);
  BlockMatrix m;
  m.reset(pattern);
  return m;
}

// The law's Hessian as a dense matrix.
inline Eigen::MatrixXd hessian_of(Law& law, const Step& step, const std::vector<Vec3>& y,
                                  bool definite) {
  const Index n = static_cast<Index>(y.size());
  BlockPattern pattern(n);
  BlockMatrix m = empty_hessian(law, pattern);
  std::vector<Vec3> g(y.size(), Vec3::Zero());
  Assembly out{&g, &m, definite};
  law.assemble(step, y, out);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (Index c = 0; c < n; ++c) {
    dense.block<3, 3>(3L * c, 3L * c) = m.diagonal[c];
    for (Index s = pattern.starts()[c]; s < pattern.starts()[c + 1]; ++s) {
      const Index r = pattern.rows()[s];
      dense.block<3, 3>(3L * r, 3L * c) = m.below[s];
      dense.block<3, 3>(3L * c, 3L * r) = m.below[s].transpose();
    }
  }
  return dense;
}

struct Mismatch {
  double gradient = 0.0;  // largest difference over the largest entry
  double hessian = 0.0;
};

// Central differences of fourth order: (-f(2d) + 8 f(d) - 8 f(-d) + f(-2d)) / 12 d. With d 1e-3 of
// the lengths the truncation d^4 f'''''/30 and the round-off eps f / d both lie near 1e-12 of
// f / length for functions that vary over a length; see the bounds at each use.
inline Mismatch compare_derivatives(Law& law, const Step& step, std::vector<Vec3> y, double d) {
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(y.size());
  const Eigen::MatrixXd hessian = hessian_of(law, step, y, false);
  const std::vector<Vec3> gradient = gradient_of(law, step, y);
  Mismatch worst;
  double scale_g = 0.0;
  for (const Vec3& g : gradient) scale_g = std::max(scale_g, g.cwiseAbs().maxCoeff());
  const double scale_h = hessian.cwiseAbs().maxCoeff();
  constexpr double kShift[4] = {2.0, 1.0, -1.0, -2.0};
  constexpr double kWeight[4] = {-1.0 / 12.0, 8.0 / 12.0, -8.0 / 12.0, 1.0 / 12.0};
  for (Eigen::Index k = 0; k < n; ++k) {
    double& x = y[k / 3][k % 3];
    const double at = x;
    double slope = 0.0;
    Eigen::VectorXd column = Eigen::VectorXd::Zero(n);
    for (int p = 0; p < 4; ++p) {
      x = at + kShift[p] * d;
      slope += kWeight[p] * law.potential(step, y) / d;
      const std::vector<Vec3> g = gradient_of(law, step, y);
      for (Eigen::Index r = 0; r < n; ++r) column(r) += kWeight[p] * g[r / 3][r % 3] / d;
    }
    x = at;
    worst.gradient = std::max(worst.gradient, std::abs(slope - gradient[k / 3][k % 3]) / scale_g);
    worst.hessian =
        std::max(worst.hessian, (column - hessian.col(k)).cwiseAbs().maxCoeff() / scale_h);
  }
  return worst;
}

inline double smallest_eigenvalue(const Eigen::MatrixXd& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(m, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double size = 1.0) {
    return size * std::uniform_real_distribution<double>(-1.0, 1.0)(engine_);
  }
  Vec3 vector(double size = 1.0) { return {number(size), number(size), number(size)}; }
  std::vector<Vec3> disturbed(std::vector<Vec3> x, double size) {
    for (Vec3& p : x) p += vector(size);
    return x;
  }

 private:
  std::mt19937 engine_;
};

}  // namespace retiarius::testing

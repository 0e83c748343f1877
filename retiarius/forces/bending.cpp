#include "retiarius/forces/bending.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace retiarius {

namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

// First and second derivatives of f(c), c = t1 . t2, with respect to the edges (e1, e2).
struct EdgeDerivatives {
  Vec6 gradient;
  Mat6 hessian;
};

struct Edges {
  Vec3 t1, t2;
  double l1, l2, c;
};

Edges edges(const std::vector<Vec3>& y, Index a, Index b, Index c) {
  Edges e;
  e.t1 = y[b] - y[a];
  e.t2 = y[c] - y[b];
  e.l1 = e.t1.norm();
  e.l2 = e.t2.norm();
  e.t1 /= e.l1;
  e.t2 /= e.l2;
  e.c = e.t1.dot(e.t2);
  return e;
}

// With P_i = (I - t_i t_i^T) / |e_i|: dc/de1 = P1 t2, dc/de2 = P2 t1,
// d2c/de1de1 = -(t1 (P1 t2)^T + (P1 t2) t1^T + c P1) / |e1|, d2c/de1de2 = P1 P2.
EdgeDerivatives differentiate(const Edges& e, const SquaredCurvature& k, bool second) {
  const Vec3 p1t2 = (e.t2 - e.c * e.t1) / e.l1;
  const Vec3 p2t1 = (e.t1 - e.c * e.t2) / e.l2;
  EdgeDerivatives d;
  Vec6 dc;
  dc << p1t2, p2t1;
  d.gradient = k.first * dc;
  if (!second) return d;
  const Mat3 p1 = (Mat3::Identity() - e.t1 * e.t1.transpose()) / e.l1;
  const Mat3 p2 = (Mat3::Identity() - e.t2 * e.t2.transpose()) / e.l2;
  Mat6 ddc;
  ddc.topLeftCorner<3, 3>() =
      -(e.t1 * p1t2.transpose() + p1t2 * e.t1.transpose() + e.c * p1) / e.l1;
  ddc.bottomRightCorner<3, 3>() =
      -(e.t2 * p2t1.transpose() + p2t1 * e.t2.transpose() + e.c * p2) / e.l2;
  ddc.topRightCorner<3, 3>() = p1 * p2;
  ddc.bottomLeftCorner<3, 3>() = ddc.topRightCorner<3, 3>().transpose();
  d.hessian = k.second * dc * dc.transpose() + k.first * ddc;
  return d;
}

Mat6 nearest_semidefinite(const Mat6& m) {
  const Eigen::SelfAdjointEigenSolver<Mat6> eigen(m);
  const Vec6 clamped = eigen.eigenvalues().cwiseMax(0.0);
  return eigen.eigenvectors() * clamped.asDiagonal() * eigen.eigenvectors().transpose();
}

void add_block(BlockMatrix& m, Index slot, bool keep, const Mat3& block) {
  if (keep) {
    m.below[slot] += block;
  } else {
    m.below[slot] += block.transpose();
  }
}

}  // namespace

SquaredCurvature squared_curvature(Bending kind, double c) {
  if (kind == Bending::bounded) return {2.0 * (1.0 - c), -2.0, 0.0};
  const double q = 1.0 + c;
  return {4.0 * (1.0 - c) / q, -8.0 / (q * q), 16.0 / (q * q * q)};
}

BendingLaw::BendingLaw(const Network& network) {
  for (const Joint& j : network.joints) {
    if (j.bending_stiffness <= 0.0) continue;
    const Bending kind = network.materials[network.segments[j.first].material].bending;
    elements_.push_back({j.a, j.b, j.c, j.bending_stiffness / (2.0 * j.voronoi_length), kind});
  }
}

void BendingLaw::couple(BlockPattern& pattern) const {
  for (const Element& e : elements_) {
    pattern.couple(e.a, e.b);
    pattern.couple(e.a, e.c);
    pattern.couple(e.b, e.c);
  }
}

void BendingLaw::bind(const BlockPattern& pattern) {
  slots_.clear();
  slots_.reserve(elements_.size());
  for (const Element& e : elements_) {
    slots_.push_back({pattern.slot(e.a, e.b), pattern.slot(e.a, e.c), pattern.slot(e.b, e.c),
                      e.a > e.b, e.a > e.c, e.b > e.c});
  }
}

double BendingLaw::potential(const Step&, const std::vector<Vec3>& y) const { return energy(y); }

double BendingLaw::energy(const std::vector<Vec3>& x) const {
  double sum = 0.0;
  for (const Element& e : elements_) {
    const Edges d = edges(x, e.a, e.b, e.c);
    if (e.kind == Bending::tangent && d.c <= -1.0) return kInfinity;
    sum += e.factor * squared_curvature(e.kind, d.c).value;
  }
  return sum;
}

void BendingLaw::assemble(const Step&, const std::vector<Vec3>& y, Assembly& out) const {
  std::vector<Vec3>& g = *out.gradient;
  for (std::size_t n = 0; n < elements_.size(); ++n) {
    const Element& e = elements_[n];
    const Edges d = edges(y, e.a, e.b, e.c);
    EdgeDerivatives f = differentiate(d, squared_curvature(e.kind, d.c), out.hessian != nullptr);
    const Vec3 g1 = e.factor * f.gradient.head<3>();
    const Vec3 g2 = e.factor * f.gradient.tail<3>();
    g[e.a] -= g1;
    g[e.b] += g1 - g2;
    g[e.c] += g2;
    if (!out.hessian) continue;
    if (out.definite) f.hessian = nearest_semidefinite(f.hessian);
    f.hessian *= e.factor;
    const Mat3 h11 = f.hessian.topLeftCorner<3, 3>();
    const Mat3 h12 = f.hessian.topRightCorner<3, 3>();
    const Mat3 h22 = f.hessian.bottomRightCorner<3, 3>();
    BlockMatrix& m = *out.hessian;
    m.diagonal[e.a] += h11;
    m.diagonal[e.b] += h11 - h12 - h12.transpose() + h22;
    m.diagonal[e.c] += h22;
    const Slots& s = slots_[n];
    add_block(m, s.ab, s.ab_row_a, h12 - h11);
    add_block(m, s.ac, s.ac_row_a, -h12);
    add_block(m, s.bc, s.bc_row_b, h12 - h22);
  }
}

std::vector<double> node_curvatures(const Network& network, const std::vector<Vec3>& x) {
  std::vector<double> result(x.size(), 0.0);
  for (const Joint& j : network.joints) {
    const Edges d = edges(x, j.a, j.b, j.c);
    const Bending kind = network.materials[network.segments[j.first].material].bending;
    const double kappa = std::sqrt(std::max(
        0.0, squared_curvature(kind == Bending::tangent ? kind : Bending::bounded, d.c).value));
    result[j.b] = std::max(result[j.b], kappa / j.voronoi_length);
  }
  return result;
}

}  // namespace retiarius

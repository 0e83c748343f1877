#include "retiarius/forces/bending.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "retiarius/forces/element_sums.hpp"

namespace retiarius {

namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

// First and second derivatives of f(c), c = t1 . t2, with respect to the edges (e1, e2).
struct EdgeDerivatives {
  Vec6 gradient;
  Mat6 hessian;
};

// A segment's direction t = e / g(|e|) with what its derivatives need. Where the segment is not
// far too short, g is its length and t its unit tangent. A slack tension-only segment can shrink to
// nothing, where the unit tangent jumps and nodes would be caught; below the share kShort of its
// rest length, g = (l^2 / s + s) / 2 with s that length, smooth to first order.
struct Direction {
  Vec3 e, t;
  double g;     // m
  double q;     // g' / (g^2 l), 1/m3: dt/de = I / g - q e e^T
  double r;     // q' / l, 1/m5
  double lack;  // 1 - t . t: none but where the segment is too short
};
constexpr double kShort = 0.2;

Direction direction(const Vec3& a, const Vec3& b, double rest_length) {
  Direction d;
  d.e = b - a;
  const double l = d.e.norm();
  const double s = kShort * rest_length;
  if (l >= s) {
    d.g = l;
    d.lack = 0.0;
    d.q = 1.0 / (l * l * l);
    d.r = -3.0 * d.q / (l * l);
  } else {
    d.g = 0.5 * (l * l / s + s);
    d.lack = 1.0 - l * l / (d.g * d.g);
    d.q = 1.0 / (s * d.g * d.g);
    d.r = -2.0 * d.q / (s * d.g);
  }
  d.t = d.e / d.g;
  return d;
}

struct Edges {
  Direction one, two;
  double c;    // t1 . t2
  double gap;  // 1 - c, with its own relative precision
};

Edges edges(const std::vector<Vec3>& y, Index a, Index b, Index c, double rest1, double rest2) {
  Edges e{direction(y[a], y[b], rest1), direction(y[b], y[c], rest2), 0.0, 0.0};
  e.c = e.one.t.dot(e.two.t);
  e.gap = 0.5 * ((e.one.t - e.two.t).squaredNorm() + e.one.lack + e.two.lack);
  return e;
}

Mat3 tangent_derivative(const Direction& d) {
  return Mat3::Identity() / d.g - d.q * d.e * d.e.transpose();
}

// d2(t . w)/de2 for a fixed w.
Mat3 second_derivative(const Direction& d, const Vec3& w) {
  const double along = d.e.dot(w);
  Mat3 m =
      -d.q * (w * d.e.transpose() + d.e * w.transpose()) - (along * d.r) * d.e * d.e.transpose();
  m.diagonal().array() -= along * d.q;
  return m;
}

// With D_i = dt_i/de_i: dc/de1 = D1 t2, dc/de2 = D2 t1, d2c/de1de2 = D1 D2. For segments of proper
// length D_i = P_i = (I - t_i t_i^T) / |e_i|.
EdgeDerivatives differentiate(const Edges& e, const SquaredCurvature& k) {
  const Mat3 d1 = tangent_derivative(e.one);
  const Mat3 d2 = tangent_derivative(e.two);
  EdgeDerivatives d;
  Vec6 dc;
  dc << d1 * e.two.t, d2 * e.one.t;
  d.gradient = k.first * dc;
  Mat6 ddc;
  ddc.topLeftCorner<3, 3>() = second_derivative(e.one, e.two.t);
  ddc.bottomRightCorner<3, 3>() = second_derivative(e.two, e.one.t);
  ddc.topRightCorner<3, 3>() = d1 * d2;
  ddc.bottomLeftCorner<3, 3>() = ddc.topRightCorner<3, 3>().transpose();
  d.hessian = k.second * dc * dc.transpose() + k.first * ddc;
  return d;
}

Mat6 nearest_semidefinite(const Mat6& m) {
  const Eigen::SelfAdjointEigenSolver<Mat6> eigen(m);
  const Vec6 clamped = eigen.eigenvalues().cwiseMax(0.0);
  return eigen.eigenvectors() * clamped.asDiagonal() * eigen.eigenvectors().transpose();
}

// The block of the pair `slot` of a joint; ~slot where its first node is the column.
void add_block(BlockMatrix& m, Index slot, const Mat3& block) {
  if (slot >= 0) {
    m.below[slot] += block;
  } else {
    m.below[~slot] += block.transpose();
  }
}

}  // namespace

SquaredCurvature squared_curvature(Bending kind, double c, double gap) {
  if (kind == Bending::bounded) return {2.0 * gap, -2.0, 0.0};
  const double q = 1.0 + c;
  return {4.0 * gap / q, -8.0 / (q * q), 16.0 / (q * q * q)};
}

BendingLaw::BendingLaw(const Network& network) {
  for (const Joint& j : network.joints) {
    if (j.bending_stiffness <= 0.0) continue;
    const Bending kind = network.materials[network.segments[j.first].material].bending;
    elements_.push_back({j.a, j.b, j.c, network.segments[j.first].rest_length,
                         network.segments[j.second].rest_length,
                         j.bending_stiffness / (2.0 * j.voronoi_length), kind});
  }
  const auto tangent =
      std::stable_partition(elements_.begin(), elements_.end(),
                            [](const Element& e) { return e.kind != Bending::tangent; });
  bounded_ = static_cast<long>(tangent - elements_.begin());
  std::vector<Index> nodes;
  for (const Element& e : elements_) {
    a_.push_back(e.a);
    b_.push_back(e.b);
    c_.push_back(e.c);
    rest1_.push_back(e.rest1);
    rest2_.push_back(e.rest2);
    factor_.push_back(e.factor);
    nodes.insert(nodes.end(), {e.a, e.b, e.c});
  }
  const std::size_t padded = elements_.size() + kernels::kElementPadding;
  for (std::vector<Index>* list : {&a_, &b_, &c_}) list->resize(padded, 0);
  for (std::vector<double>* list : {&rest1_, &rest2_, &factor_}) list->resize(padded, 1.0);
  chunks_ = ElementChunks(nodes, 3);
}

void BendingLaw::couple(BlockPattern& pattern) const {
  for (const Element& e : elements_) {
    pattern.couple(e.a, e.b);
    pattern.couple(e.a, e.c);
    pattern.couple(e.b, e.c);
  }
}

void BendingLaw::bind(const BlockPattern& pattern) {
  const auto slot = [&](Index i, Index j) {
    const Index s = pattern.slot(i, j);
    return i > j ? s : ~s;
  };
  for (std::vector<Index>* list : {&ab_, &ac_, &bc_}) list->assign(a_.size(), 0);
  for (std::size_t n = 0; n < elements_.size(); ++n) {
    const Element& e = elements_[n];
    ab_[n] = slot(e.a, e.b);
    ac_[n] = slot(e.a, e.c);
    bc_[n] = slot(e.b, e.c);
  }
}

double BendingLaw::sum(const std::vector<Vec3>& y, const kernels::ElementSums& out) const {
  if (elements_.empty()) return 0.0;
  const kernels::JointArrays arrays{a_.data(),     b_.data(),     c_.data(),
                                    ab_.data(),    ac_.data(),    bc_.data(),
                                    rest1_.data(), rest2_.data(), factor_.data()};
  const kernels::ElementTable& table = kernels::elements();
  const double* const x = y.front().data();
  return chunks_.sum([&](long begin, long end) {
    const long border = std::clamp(bounded_, begin, end);
    double part = 0.0;
    if (begin < border) part += table.bounded_bending(arrays, begin, border, x, out);
    if (border < end) part += table.tangent_bending(arrays, border, end, x, out);
    return part;
  });
}

double BendingLaw::potential(const Step&, const std::vector<Vec3>& y) const { return energy(y); }

double BendingLaw::energy(const std::vector<Vec3>& x) const {
  return sum(x, {nullptr, nullptr, nullptr});
}

double BendingLaw::assemble(const Step&, const std::vector<Vec3>& y, Assembly& out) const {
  if (!out.hessian || !out.definite) return sum(y, element_sums(out));
  assemble_definite(y, out);
  return energy(y);
}

// Element by element: eigenvalues are needed rarely, where the matrix was not definite.
void BendingLaw::assemble_definite(const std::vector<Vec3>& y, Assembly& out) const {
  std::vector<Vec3>& g = *out.gradient;
  BlockMatrix& m = *out.hessian;
  for (std::size_t n = 0; n < elements_.size(); ++n) {
    const Element& e = elements_[n];
    const Edges d = edges(y, e.a, e.b, e.c, e.rest1, e.rest2);
    const EdgeDerivatives f = differentiate(d, squared_curvature(e.kind, d.c, d.gap));
    const Vec3 g1 = e.factor * f.gradient.head<3>();
    const Vec3 g2 = e.factor * f.gradient.tail<3>();
    g[e.a] -= g1;
    g[e.b] += g1 - g2;
    g[e.c] += g2;
    const Mat6 hessian = e.factor * nearest_semidefinite(f.hessian);
    const Mat3 h11 = hessian.topLeftCorner<3, 3>();
    const Mat3 h12 = hessian.topRightCorner<3, 3>();
    const Mat3 h22 = hessian.bottomRightCorner<3, 3>();
    m.diagonal[e.a] += h11;
    m.diagonal[e.b] += h11 - h12 - h12.transpose() + h22;
    m.diagonal[e.c] += h22;
    add_block(m, ab_[n], h12 - h11);
    add_block(m, ac_[n], -h12);
    add_block(m, bc_[n], h12 - h22);
  }
}

std::vector<double> node_curvatures(const Network& network, const std::vector<Vec3>& x) {
  std::vector<double> result(x.size(), 0.0);
  for (const Joint& j : network.joints) {
    const Edges d = edges(x, j.a, j.b, j.c, network.segments[j.first].rest_length,
                          network.segments[j.second].rest_length);
    const Bending kind = network.materials[network.segments[j.first].material].bending;
    const double kappa = std::sqrt(std::max(
        0.0,
        squared_curvature(kind == Bending::tangent ? kind : Bending::bounded, d.c, d.gap).value));
    result[j.b] = std::max(result[j.b], kappa / j.voronoi_length);
  }
  return result;
}

}  // namespace retiarius

// Distances between primitives with first and second derivatives.
#pragma once

#include <cstdint>

#include "retiarius/contact/contact_pair.hpp"

namespace retiarius {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

// The closest points of two primitives. Their difference is u = sum w_i p_i with weights of sum 0,
// positive on the first primitive and negative on the second; d = |u|, n = u / d, and the gradient
// of d in p_i is w_i n.
//
// Accuracy, with L the largest distance of a point from the first and eps the machine's: d is
// within 40 eps L of the true one, and so is the distance of the stated closest points. Of edges at
// an angle a below 1e-10 whose interiors are nearest the distance is that of an end of one of them,
// too large by at most (a L)^2 / 2d and never by more than 1e-10 L. The normal is within 80 eps L /
// d.
struct Distance {
  double value = kInfinity;        // d, m; of point_plane signed
  Vec3 normal = Vec3::UnitZ();     // n, unit, from the second primitive to the first
  std::array<double, 4> weight{};  // w_i
  std::uint8_t active = 0;         // bit i: point i is one of the feature's that is closest
  bool is_active(int i) const { return (active >> i) & 1; }
};

// Distance of a pair's points p (see PairPositions). Where d = 0 the normal is a unit vector across
// the features that meet. Zero-length edges and triangles without area are taken as the point or
// edge that they are.
Distance distance(PairKind kind, const PairPositions& p);

// The gradient of d in the 4x3 coordinates; rows of points that the kind lacks are 0.
Vec12 distance_gradient(const Distance& at);

// The Hessian of d in the 4x3 coordinates. With the free parameters s of the closest points on
// their features, e_k = du/ds_k and G_kl = e_k . e_l,
//   H = w w^T (x) Q / d - sum_kl G^-1_kl [ w w'_l^T (x) e_k n^T + its transpose ]
//       - d sum_kl G^-1_kl w'_k w'_l^T (x) n n^T,
// where Q projects on what is normal to n and all e_k. On a plane it is 0. d must not be 0 unless
// the feature has two free parameters.
Mat12 distance_hessian(const Distance& at, const PairPositions& p);

// dn/dt where the points move with these velocities, per unit of their time; across n. Not finite
// where d = 0 and the feature has fewer than two free parameters.
Vec3 normal_rate(const Distance& at, const PairPositions& p, const PairPositions& velocity);

// The weight of a pair of edges that is 1 unless they are nearly parallel, where it falls to 0
// smoothly, so that a barrier weighted with it has a continuous gradient (Li et al. 2020, Eq. 24):
// m = c/e (2 - c/e) for c = |a x b|^2 < e, with a = p1 - p0, b = p3 - p2.
struct EdgeWeight {
  double value = 1.0;
  Vec12 gradient = Vec12::Zero();
  Mat12 hessian = Mat12::Zero();
};
EdgeWeight edge_weight(const PairPositions& p, double threshold);

// The value alone.
double edge_weight_value(const PairPositions& p, double threshold);

// The threshold e for edges of these rest lengths, m4: 1e-3 of the product of their squares.
inline double edge_weight_threshold(double first_length, double second_length) {
  return 1e-3 * (first_length * first_length) * (second_length * second_length);
}

}  // namespace retiarius

#include "retiarius/contact/distance.hpp"

namespace retiarius {
namespace {

constexpr std::size_t size_of(int i) { return static_cast<std::size_t>(i); }

// A feature's points below this index belong to the first primitive.
int first_points(const Distance& at) { return at.weight[1] > 0.0 || at.weight[0] == 0.0 ? 2 : 1; }

// The free parameters s_k of the closest points on the features that are active.
struct FreeParameters {
  int count = 0;
  std::array<Vec3, 2> direction;                      // e_k = du/ds_k
  std::array<std::array<double, 4>, 2> weight{};      // w'_k = dw/ds_k
  Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();  // G^-1

  FreeParameters(const Distance& at, const PairPositions& p) {
    const int split = first_points(at);
    add_side(at, p, 0, split, 1.0);
    add_side(at, p, split, 4, -1.0);
    if (count == 1) inverse(0, 0) = 1.0 / direction[0].squaredNorm();
    if (count == 2) {
      const double across = direction[0].dot(direction[1]);
      inverse << direction[1].squaredNorm(), -across, -across, direction[0].squaredNorm();
      // The determinant of G, without the cancellation of a difference of products.
      inverse /= direction[0].cross(direction[1]).squaredNorm();
    }
  }

 private:
  // The active points in [begin, end) of one side: u grows with the first primitive's points (sign
  // 1) and against the second's (-1).
  void add_side(const Distance& at, const PairPositions& p, int begin, int end, double sign) {
    int base = -1;
    for (int i = begin; i < end; ++i) {
      if (!at.is_active(i)) continue;
      if (base < 0) {
        base = i;
      } else {
        const std::size_t k = size_of(count++);
        direction[k] = sign * (p[size_of(i)] - p[size_of(base)]);
        weight[k][size_of(i)] = sign;
        weight[k][size_of(base)] = -sign;
      }
    }
  }
};

Mat3 normal_projection(const Vec3& n, const FreeParameters& free) {
  if (free.count == 0) return Mat3::Identity() - n * n.transpose();
  if (free.count == 2) return Mat3::Zero();
  const Vec3 across = n.cross(free.direction[0]).normalized();
  return across * across.transpose();
}

Mat12 outer(const Vec12& a, const Vec12& b) { return a * b.transpose(); }

// w (x) v as a vector of 12.
Vec12 spread(const std::array<double, 4>& w, const Vec3& v) {
  Vec12 out;
  for (int i = 0; i < 4; ++i) out.segment<3>(3L * i) = w[size_of(i)] * v;
  return out;
}

}  // namespace

Vec12 distance_gradient(const Distance& at) { return spread(at.weight, at.normal); }

Mat12 distance_hessian(const Distance& at, const PairPositions& p) {
  Mat12 out = Mat12::Zero();
  double sum = 0.0;
  for (const double w : at.weight) sum += w;
  if (sum > 0.5) return out;  // a plane's point

  const FreeParameters free(at, p);
  const Vec3& n = at.normal;
  if (free.count < 2) {
    const Mat3 across = normal_projection(n, free) / at.value;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const double ww = at.weight[size_of(i)] * at.weight[size_of(j)];
        if (ww != 0.0) out.block<3, 3>(3L * i, 3L * j) += ww * across;
      }
    }
  }
  for (std::size_t k = 0; k < size_of(free.count); ++k) {
    for (std::size_t l = 0; l < size_of(free.count); ++l) {
      const double g = free.inverse(static_cast<int>(k), static_cast<int>(l));
      const Vec12 turned = spread(free.weight[l], n);
      const Mat12 mixed = outer(spread(at.weight, free.direction[k]), turned);
      out -= g * (mixed + mixed.transpose());
      out -= g * at.value * outer(spread(free.weight[k], n), turned);
    }
  }
  return out;
}

Vec3 normal_rate(const Distance& at, const PairPositions& p, const PairPositions& velocity) {
  FreeParameters free(at, p);
  Vec3 relative = Vec3::Zero();  // velocity of the closest points as material ones
  for (int i = 0; i < 4; ++i)
    if (at.is_active(i)) relative += at.weight[size_of(i)] * velocity[size_of(i)];
  const Vec3& n = at.normal;
  Vec3 rate = Vec3::Zero();
  if (free.count < 2) rate = normal_projection(n, free) * relative / at.value;
  for (std::size_t k = 0; k < size_of(free.count); ++k) {
    for (std::size_t l = 0; l < size_of(free.count); ++l) {
      Vec3 stretch = Vec3::Zero();  // de_l/dt
      for (std::size_t i = 0; i < 4; ++i) stretch += free.weight[l][i] * velocity[i];
      rate -= free.inverse(static_cast<int>(k), static_cast<int>(l)) * n.dot(stretch) *
              free.direction[k];
    }
  }
  return rate - n.dot(rate) * n;
}

double edge_weight_value(const PairPositions& p, double threshold) {
  const double share = (p[1] - p[0]).cross(p[3] - p[2]).squaredNorm() / threshold;
  return share < 1.0 ? share * (2.0 - share) : 1.0;
}

EdgeWeight edge_weight(const PairPositions& p, double threshold) {
  EdgeWeight out;
  const Vec3 a = p[1] - p[0], b = p[3] - p[2];
  const Vec3 cross = a.cross(b);
  const double c = cross.squaredNorm();
  if (c >= threshold) return out;
  // c in terms of a and b, then of the points: a = p1 - p0, b = p3 - p2.
  const Vec3 ca = 2.0 * b.cross(cross), cb = 2.0 * cross.cross(a);
  const Mat3 identity = Mat3::Identity();
  const Mat3 caa = 2.0 * (b.squaredNorm() * identity - b * b.transpose());
  const Mat3 cbb = 2.0 * (a.squaredNorm() * identity - a * a.transpose());
  const Mat3 cab = 2.0 * (2.0 * a * b.transpose() - a.dot(b) * identity - b * a.transpose());
  Vec12 gradient;
  gradient << -ca, ca, -cb, cb;
  Mat12 hessian;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const double sign = i == j ? 1.0 : -1.0;
      hessian.block<3, 3>(3L * i, 3L * j) = sign * caa;
      hessian.block<3, 3>(6 + 3L * i, 6 + 3L * j) = sign * cbb;
      hessian.block<3, 3>(3L * i, 6 + 3L * j) = sign * cab;
      hessian.block<3, 3>(6 + 3L * j, 3L * i) = sign * cab.transpose();
    }
  }
  const double share = c / threshold;
  const double slope = 2.0 / threshold * (1.0 - share), bend = -2.0 / (threshold * threshold);
  out.value = share * (2.0 - share);
  out.gradient = slope * gradient;
  out.hessian = slope * hessian + bend * gradient * gradient.transpose();
  return out;
}

}  // namespace retiarius

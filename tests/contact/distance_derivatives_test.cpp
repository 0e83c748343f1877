#include <cmath>

#include "retiarius/contact/distance.hpp"
#include "tests/contact/distance_oracle.hpp"

namespace retiarius {
namespace {

using testing::exact_distance;
using testing::Quad;
using testing::quad;
using testing::QuadPositions;
using testing::Stream;

// Central differences in quadruple precision with step h.
template <class Function>
Vec12 difference_gradient(const PairPositions& p, double h, Function&& f) {
  Vec12 out;
  QuadPositions q = quad(p);
  for (int i = 0; i < 12; ++i) {
    Quad& x = q[static_cast<std::size_t>(i / 3)][i % 3];
    const Quad at = x;
    x = at + h;
    const Quad above = f(q);
    x = at - h;
    const Quad below = f(q);
    x = at;
    out[i] = static_cast<double>((above - below) / (2 * Quad(h)));
  }
  return out;
}

template <class Function>
Mat12 difference_hessian(const PairPositions& p, double h, Function&& f) {
  Mat12 out;
  QuadPositions q = quad(p);
  const auto at = [&](int i) -> Quad& { return q[static_cast<std::size_t>(i / 3)][i % 3]; };
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 12; ++j) {
      const Quad xi = at(i), xj = at(j);
      Quad sum = 0;
      for (int a = -1; a <= 1; a += 2) {
        for (int b = -1; b <= 1; b += 2) {
          at(i) += Quad(a) * Quad(h);
          at(j) += Quad(b) * Quad(h);
          sum += a * b * f(q);
          at(i) = xi;
          at(j) = xj;
        }
      }
      out(i, j) = static_cast<double>(sum / (4 * Quad(h) * Quad(h)));
    }
  }
  return out;
}

struct Errors {
  double gradient = 0.0, hessian = 0.0;  // largest difference over the largest entry
};

Errors derivative_errors(PairKind kind, const PairPositions& p, double h) {
  const auto f = [&](const QuadPositions& q) { return exact_distance(kind, q); };
  const Distance at = distance(kind, p);
  const Mat12 hessian = distance_hessian(at, p), expected = difference_hessian(p, h, f);
  Errors out;
  out.gradient = (distance_gradient(at) - difference_gradient(p, h, f)).cwiseAbs().maxCoeff();
  out.hessian = (hessian - expected).cwiseAbs().maxCoeff() /
                std::max(1.0 / testing::extent(p), expected.cwiseAbs().maxCoeff());
  return out;
}

// Pairs whose closest features and their neighbours are farther apart than the differences reach:
// the second derivative jumps from feature to feature.
bool is_smooth(const Distance& at, double margin) {
  for (int i = 0; i < 4; ++i) {
    const double w = std::abs(at.weight[static_cast<std::size_t>(i)]);
    if (at.is_active(i) && w < margin) return false;
  }
  return true;
}

TEST(DistanceDerivatives, OfRandomPairs) {
  Stream random(3);
  int checked[16] = {};
  for (int k = 0; k < 400; ++k) {
    PairPositions p;
    for (Vec3& x : p) x = random.vector();
    for (const PairKind kind : testing::kBoundedKinds) {
      const Distance at = distance(kind, p);
      if (at.value < 0.05 || !is_smooth(at, 1e-3)) continue;
      const Errors errors = derivative_errors(kind, p, 1e-9);
      EXPECT_LT(errors.gradient, 1e-12) << k;
      EXPECT_LT(errors.hessian, 1e-10) << k;
      ++checked[at.active];
    }
  }
  // Every type: corner-corner, corner-edge, corner-face, edge-edge.
  EXPECT_GT(checked[0b0011], 100);
  EXPECT_GT(checked[0b0111], 100);
  EXPECT_GT(checked[0b1111], 50);
}

// Small distances make the curvature 1/d large; the exact one is found all the same.
TEST(DistanceDerivatives, NearContact) {
  Stream random(4);
  for (double d = 1e-1; d > 1e-7; d *= 0.1) {
    for (int k = 0; k < 20; ++k) {
      PairPositions p;
      for (Vec3& x : p) x = random.vector();
      const Vec3 cross = (p[1] - p[0]).cross(p[3] - p[2]).normalized();
      const double s = random.uniform(0.1, 0.9), t = random.uniform(0.1, 0.9);
      const Vec3 shift = p[0] + s * (p[1] - p[0]) + d * cross - p[2] - t * (p[3] - p[2]);
      p[2] += shift;
      p[3] += shift;
      const Errors edges = derivative_errors(PairKind::edge_edge, p, 1e-6 * d);
      EXPECT_LT(edges.gradient, 1e-13 / d + 1e-11) << d;
      EXPECT_LT(edges.hessian, 1e-7) << d;
      p[0] = (p[1] + p[2] + p[3]) / 3.0;
      p[0] += d * (p[2] - p[1]).cross(p[3] - p[1]).normalized();
      EXPECT_LT(derivative_errors(PairKind::point_triangle, p, 1e-6 * d).hessian, 1e-7) << d;
      p[0] = 0.4 * p[1] + 0.6 * p[2] + d * (p[2] - p[1]).unitOrthogonal();
      EXPECT_LT(derivative_errors(PairKind::point_edge, p, 1e-6 * d).hessian, 1e-7) << d;
    }
  }
}

// Edges at small angles whose interiors are closest: 1/sin2 is large, its relative error stays.
TEST(DistanceDerivatives, OfNearlyParallelEdges) {
  for (double angle = 1e-1; angle > 1e-6; angle *= 0.1) {
    const Vec3 along(std::cos(angle), std::sin(angle), 0.0);
    const PairPositions p{Vec3(-1.1, 0, 0), Vec3(0.9, 0, 0), Vec3(0, 0, 0.3) - 0.8 * along,
                          Vec3(0, 0, 0.3) + along};
    const Distance at = distance(PairKind::edge_edge, p);
    ASSERT_EQ(at.active, 0b1111) << angle;
    const Errors errors = derivative_errors(PairKind::edge_edge, p, 1e-6 * angle);
    EXPECT_LT(errors.gradient, 1e-14 / angle + 1e-9) << angle;
    EXPECT_LT(errors.hessian, 1e-6) << angle;
  }
}

// Where the projection falls exactly on an end of a feature, the gradient is continuous, and the
// Hessian is that of one of the sides.
TEST(DistanceDerivatives, AtCoincidentProjections) {
  struct Case {
    PairKind kind;
    PairPositions p;
    Vec3 along;  // by which point 0 leaves the border
  };
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  const Case cases[] = {
      {PairKind::point_edge, {Vec3(0, 0.5, 0.5), a, b, {}}, Vec3(1, 0, 0)},
      {PairKind::point_edge, {Vec3(1, 0.5, 0), a, b, {}}, Vec3(1, 0, 0)},
      {PairKind::point_triangle, {Vec3(0.5, 0, 0.7), a, b, c}, Vec3(0, 1, 0)},
      {PairKind::point_triangle, {Vec3(0, 0, 0.7), a, b, c}, Vec3(1, 1, 0)},
      {PairKind::point_triangle, {Vec3(0.5, 0.5, 0.7), a, b, c}, Vec3(1, 1, 0)},
      {PairKind::edge_edge, {Vec3(0.5, 0, 0.7), Vec3(0.5, -2, 0.7), a, b}, Vec3(0, 1, 0)},
      {PairKind::edge_edge, {Vec3(0, 0, 0.7), Vec3(-1, -2, 0.7), a, b}, Vec3(1, 1, 0)}};
  for (const Case& at_border : cases) {
    const Distance at = distance(at_border.kind, at_border.p);
    const auto f = [&](const QuadPositions& q) { return exact_distance(at_border.kind, q); };
    EXPECT_LT((distance_gradient(at) - difference_gradient(at_border.p, 1e-12, f)).norm(), 1e-10);
    const Mat12 hessian = distance_hessian(at, at_border.p);
    double nearest = kInfinity;
    for (const double side : {-1e-6, 1e-6}) {
      PairPositions p = at_border.p;
      p[0] += side * at_border.along;
      const Mat12 beside = difference_hessian(p, 1e-9, f);
      nearest = std::min(nearest, (beside - hessian).cwiseAbs().maxCoeff());
      // The library's own, on this side.
      EXPECT_LT(derivative_errors(at_border.kind, p, 1e-9).hessian, 1e-8);
    }
    EXPECT_LT(nearest, 2e-5);
  }
}

TEST(DistanceDerivatives, NormalRateIsThatOfTheNormal) {
  Stream random(6);
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 300; ++k) {
    PairPositions p, velocity;
    for (Vec3& x : p) x = random.vector();
    for (Vec3& x : velocity) x = random.vector();
    for (const PairKind kind : testing::kBoundedKinds) {
      const Distance at = distance(kind, p);
      if (at.value < 0.1 || !is_smooth(at, 1e-2)) continue;
      Vec3 ends[2];
      for (int side = 0; side < 2; ++side) {
        PairPositions moved = p;
        for (std::size_t i = 0; i < 4; ++i) moved[i] += (side ? kStep : -kStep) * velocity[i];
        ends[side] = distance(kind, moved).normal;
      }
      const Vec3 slope = (ends[1] - ends[0]) / (2.0 * kStep);
      EXPECT_LT((normal_rate(at, p, velocity) - slope).norm(), 1e-6 * (1.0 + slope.norm()));
    }
  }
}

TEST(DistanceDerivatives, OfAPlane) {
  const Vec3 normal = Vec3(1, 2, -2) / 3.0;
  const PairPositions p{Vec3(1, 1, 1), Vec3(0, 0, 1), Vec3(0, 0, 1) + normal, Vec3::Zero()};
  const Distance at = distance(PairKind::point_plane, p);
  EXPECT_LT((distance_gradient(at).head<3>() - normal).norm(), 1e-15);
  EXPECT_TRUE(distance_gradient(at).tail<9>().isZero(0.0));
  EXPECT_TRUE(distance_hessian(at, p).isZero(0.0));
}

Quad exact_weight(const QuadPositions& q, double threshold) {
  const auto cross = (q[1] - q[0]).cross(q[3] - q[2]);
  const Quad share = cross.dot(cross) / Quad(threshold);
  return share < 1 ? share * (2 - share) : Quad(1);
}

TEST(EdgeWeight, HasItsDerivatives) {
  Stream random(5);
  int below = 0;
  for (int k = 0; k < 200; ++k) {
    PairPositions p;
    for (Vec3& x : p) x = random.vector();
    p[3] = p[2] + 1.3 * (p[1] - p[0]) + random.scale(1e-8, 1.0) * random.direction();
    const double threshold = 0.05 * (p[1] - p[0]).squaredNorm() * (p[3] - p[2]).squaredNorm();
    const auto f = [&](const QuadPositions& q) { return exact_weight(q, threshold); };
    const EdgeWeight weight = edge_weight(p, threshold);
    EXPECT_NEAR(weight.value, static_cast<double>(f(quad(p))), 1e-13);
    EXPECT_EQ(weight.value, edge_weight_value(p, threshold));
    const Vec12 slope = difference_gradient(p, 1e-10, f);
    EXPECT_LT((weight.gradient - slope).norm(), 1e-11 * (1.0 + slope.norm()));
    const Mat12 bend = difference_hessian(p, 1e-10, f);
    EXPECT_LT((weight.hessian - bend).norm(), 1e-10 * (1.0 + bend.norm()));
    below += weight.value < 1.0;
  }
  EXPECT_GT(below, 100);
}

// What the weight is for: weight times a function of the distance has a gradient that is
// continuous through parallel edges, where the distance alone has a kink.
TEST(EdgeWeight, SmoothsTheDistanceOfParallelEdges) {
  const auto gradient = [](double lift, bool weighted) -> Vec12 {
    const PairPositions p{Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(-0.9, 0, 0.3 - lift),
                          Vec3(0.8, 0, 0.3 + lift)};
    const double threshold = edge_weight_threshold(2.0, 1.7);
    const Distance at = distance(PairKind::edge_edge, p);
    if (!weighted) return distance_gradient(at);
    const EdgeWeight weight = edge_weight(p, threshold);
    return weight.gradient * (at.value * at.value) +
           weight.value * 2.0 * at.value * distance_gradient(at);
  };
  for (double lift = 1e-3; lift > 1e-9; lift *= 0.1) {
    EXPECT_GT((gradient(lift, false) - gradient(-lift, false)).norm(), 0.5);
    EXPECT_LT((gradient(lift, true) - gradient(-lift, true)).norm(), 1000.0 * lift);
  }
  EXPECT_EQ(gradient(0.0, true).norm(), 0.0);
}

}  // namespace
}  // namespace retiarius

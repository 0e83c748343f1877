#include "retiarius/solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace retiarius {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

// A problem in a few scalars with its derivatives given.
class Scalars : public NewtonProblem {
 public:
  Vector x, base, direction, gradient;
  Vector kept_base, kept_direction;
  int kept = 0, restored = 0;  // times that was done
  Matrix hessian;
  Eigen::LLT<Matrix> factor;
  int factorisations = 0;
  std::function<double(const Vector&)> value;
  std::function<Vector(const Vector&)> slope_of;
  std::function<Matrix(const Vector&)> curvature;
  std::function<bool(bool)> on_revise;
  double residual_scale = 1e-12;
  std::vector<double> residuals;  // at each direction
  bool touches = false;
  std::vector<Projected> assembled;
  int evaluations = 0;  // without the Hessian

  double assemble(Projected projected) override {
    gradient = slope_of(x);
    hessian = curvature(x);
    assembled.push_back(projected);
    if (projected == Projected::everything || (touches && projected == Projected::contact)) {
      const Eigen::SelfAdjointEigenSolver<Matrix> eigen(hessian);
      hessian = eigen.eigenvectors() *
                eigen.eigenvalues().cwiseMax(1e-3).asDiagonal().toDenseMatrix() *
                eigen.eigenvectors().transpose();
    }
    return value(x);
  }
  bool has_contact() const override { return touches; }
  double evaluate() override {
    ++evaluations;
    gradient = slope_of(x);
    return value(x);
  }
  double potential() override { return value(x); }
  bool find_direction() override {
    factor.compute(hessian);
    if (factor.info() != Eigen::Success) return false;
    ++factorisations;
    reuse_direction();
    return true;
  }
  void reuse_direction() override {
    residuals.push_back(gradient.norm());
    base = x;
    direction = factor.solve(-gradient);
  }
  double slope() const override { return gradient.dot(direction); }
  void move(double fraction) override { x = base + fraction * direction; }
  void keep_direction() override {
    ++kept;
    kept_base = base;
    kept_direction = direction;
  }
  void restore_direction() override {
    ++restored;
    base = kept_base;
    direction = kept_direction;
  }
  void linearise() override { gradient += hessian * direction; }
  double direction_size() const override { return direction.norm(); }
  double residual_ratio() const override { return gradient.norm() / residual_scale; }
  double force = 0.0;  // the largest
  double largest_force() const override { return force; }
  bool revise(bool full) override { return on_revise && on_revise(full); }
};

// cosh(x0) + cosh(2 x1) + x0 x1 / 2: smooth and convex.
Scalars smooth(double x0, double x1) {
  Scalars p;
  p.x = Vector::Zero(2);
  p.x << x0, x1;
  p.value = [](const Vector& x) {
    return std::cosh(x[0]) + std::cosh(2 * x[1]) + 0.5 * x[0] * x[1] + x[0];
  };
  p.slope_of = [](const Vector& x) {
    return Vector(
        Eigen::Vector2d(std::sinh(x[0]) + 0.5 * x[1] + 1.0, 2 * std::sinh(2 * x[1]) + 0.5 * x[0]));
  };
  p.curvature = [](const Vector& x) {
    Matrix m(2, 2);
    m << std::cosh(x[0]), 0.5, 0.5, 4 * std::cosh(2 * x[1]);
    return m;
  };
  return p;
}

NewtonSettings to(double tolerance) {
  NewtonSettings s;
  s.step_tolerance = tolerance;
  return s;
}

TEST(Newton, ConvergesQuadratically) {
  Scalars p = smooth(1.0, 0.7);
  NewtonSettings settings = to(1e-10);
  settings.reuse = false;
  const NewtonResult r = minimise(p, settings);
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_EQ(r.projections, 0);
  EXPECT_EQ(r.factorisations, r.iterations);
  EXPECT_LE(r.iterations, 10);
  EXPECT_LT(p.gradient.norm(), 1e-12);
  // |r_{k+1}| <= C |r_k|^2 once near the minimum, with C of the size of the third derivatives.
  int checked = 0;
  for (std::size_t k = 0; k + 1 < p.residuals.size(); ++k) {
    if (p.residuals[k] > 0.3 || p.residuals[k + 1] < 1e-14) continue;
    EXPECT_LT(p.residuals[k + 1], 2.0 * p.residuals[k] * p.residuals[k]);
    ++checked;
  }
  EXPECT_GE(checked, 2);
}

// The minimum is the same, with fewer factorisations and a few more iterations.
TEST(Newton, KeepsAFactorisationWhileItServes) {
  Scalars fresh = smooth(1.0, 0.7);
  NewtonSettings settings = to(1e-10);
  settings.reuse = false;
  const NewtonResult direct = minimise(fresh, settings);
  Scalars kept = smooth(1.0, 0.7);
  const NewtonResult r = minimise(kept, to(1e-10));
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_LT(r.factorisations, direct.factorisations);
  EXPECT_EQ(kept.factorisations, r.factorisations);
  EXPECT_LE(r.iterations, direct.iterations + 5);
  EXPECT_LT((kept.x - fresh.x).norm(), 1e-11);
}

// A short first step tells that the second will be much shorter: one factorisation serves for both.
TEST(Newton, KeepsAFactorisationAfterAShortStep) {
  Scalars far = smooth(1.0, 0.7);
  ASSERT_TRUE(minimise(far, to(1e-12)).converged);
  NewtonSettings settings = to(1e-10);
  Scalars never = smooth(far.x[0] + 0.01, far.x[1] - 0.01);
  EXPECT_EQ(minimise(never, settings).factorisations, 2);
  settings.chord_step = 0.03;
  Scalars kept = smooth(far.x[0] + 0.01, far.x[1] - 0.01);
  const NewtonResult r = minimise(kept, settings);
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_EQ(r.factorisations, 1);
  EXPECT_LT((kept.x - far.x).norm(), 1e-10);
  settings.reuse = false;
  Scalars fresh = smooth(far.x[0] + 0.01, far.x[1] - 0.01);
  EXPECT_GT(minimise(fresh, settings).factorisations, 1);
}

// A kink, as where a slack thread becomes taut: (x + 1)^2 / 2 with another 1000 x^2 / 2 beyond 0,
// and its mirror image in a second unknown coupled to the first.
TEST(Newton, GivesUpAnOldFactorisationThatDoesNotServe) {
  Scalars p = smooth(0, 0);
  p.x << -3.0, 2.0;
  p.value = [](const Vector& x) {
    const double taut = std::max(0.0, x[0]), other = std::max(0.0, -x[1]);
    return 0.5 * x.squaredNorm() + 500.0 * (taut * taut + other * other) - 2.0 * x[0] + x[1] +
           0.25 * x[0] * x[1];
  };
  p.slope_of = [](const Vector& x) {
    return Vector(Eigen::Vector2d(x[0] + 1000.0 * std::max(0.0, x[0]) - 2.0 + 0.25 * x[1],
                                  x[1] - 1000.0 * std::max(0.0, -x[1]) + 1.0 + 0.25 * x[0]));
  };
  p.curvature = [](const Vector& x) {
    Matrix m(2, 2);
    m << (x[0] > 0 ? 1001.0 : 1.0), 0.25, 0.25, (x[1] < 0 ? 1001.0 : 1.0);
    return m;
  };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_LT(p.gradient.norm(), 1e-12);
  EXPECT_LE(r.iterations, 20);
}

// (x^2 - 1)^2 from where it is concave.
TEST(Newton, ProjectsWhereTheHessianIsIndefinite) {
  Scalars p;
  p.x = Vector::Constant(1, 0.1);
  p.value = [](const Vector& x) { return std::pow(x[0] * x[0] - 1.0, 2); };
  p.slope_of = [](const Vector& x) { return Vector(4.0 * x * (x[0] * x[0] - 1.0)); };
  p.curvature = [](const Vector& x) {
    return Matrix(Matrix::Constant(1, 1, 12 * x[0] * x[0] - 4));
  };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_GT(r.projections, 0);
  EXPECT_NEAR(p.x[0], 1.0, 1e-10);
}

// The same as if it came of contact: once a matrix had to be projected the next three are at once.
TEST(Newton, KeepsContactProjectedForThreeMatrices) {
  Scalars p;
  p.touches = true;
  p.x = Vector::Constant(1, 1e-9);
  p.value = [](const Vector& x) { return std::pow(x[0] * x[0] - 1.0, 2); };
  p.slope_of = [](const Vector& x) { return Vector(4.0 * x * (x[0] * x[0] - 1.0)); };
  p.curvature = [](const Vector& x) {
    return Matrix(Matrix::Constant(1, 1, 12 * x[0] * x[0] - 4));
  };
  NewtonSettings settings = to(1e-10);
  settings.reuse = false;
  const NewtonResult r = minimise(p, settings);
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_NEAR(p.x[0], 1.0, 1e-10);
  ASSERT_GT(p.assembled.size(), 5u);
  EXPECT_EQ(p.assembled[0], Projected::nothing);
  for (int k : {1, 2, 3, 4}) EXPECT_EQ(p.assembled[k], Projected::contact) << k;
  EXPECT_EQ(p.assembled.back(), Projected::nothing);
  EXPECT_EQ(std::count(p.assembled.begin(), p.assembled.end(), Projected::everything), 0);
}

// A thread that becomes taut at x = 0.3 is 10^7 times as stiff as what is known of the potential
// before: by secants alone the search would creep towards it from below.
TEST(Newton, LineSearchFindsAKinkInFewTrials) {
  constexpr double kStiff = 1e7;
  const auto beyond = [](const Vector& x) { return std::max(0.0, x[0] - 0.3); };
  Scalars p;
  p.x = Vector::Constant(1, 0.0);
  p.value = [&](const Vector& x) {
    return 0.5 * std::pow(x[0] - 1.0, 2) + 0.5 * kStiff * std::pow(beyond(x), 2);
  };
  p.slope_of = [&](const Vector& x) {
    return Vector(Vector::Constant(1, x[0] - 1.0 + kStiff * beyond(x)));
  };
  p.curvature = [&](const Vector& x) {
    return Matrix(Matrix::Constant(1, 1, 1.0 + (beyond(x) > 0.0 ? kStiff : 0.0)));
  };
  NewtonSettings settings = to(1e-10);
  settings.reuse = false;
  settings.max_iterations = 1;
  minimise(p, settings);
  EXPECT_NEAR(p.x[0], 0.3, 0.01);
  EXPECT_GT(p.evaluations, 0);
  EXPECT_LE(p.evaluations, 15);
}

// sqrt(1 + x^2): a full Newton step from x overshoots to -x^3 and diverges beyond 1.
TEST(Newton, LineSearchTamesOvershoot) {
  Scalars p;
  p.x = Vector::Constant(1, 4.0);
  p.value = [](const Vector& x) { return std::sqrt(1.0 + x[0] * x[0]); };
  p.slope_of = [](const Vector& x) { return Vector(x / std::sqrt(1.0 + x[0] * x[0])); };
  p.curvature = [](const Vector& x) {
    return Matrix(Matrix::Constant(1, 1, std::pow(1.0 + x[0] * x[0], -1.5)));
  };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_NEAR(p.x[0], 0.0, 1e-12);
}

// A mass on a stiff link that nothing strains at first, pulled round: energy K (|x| - 1)^2 / 2 - F
// x0 and inertia. Along a direction, which is tangential, the link gets longer in second order.
// Across the link the Hessian has the force that it carries at last, as if foretold.
Scalars link(double stiffness, double angle) {
  constexpr double kPull = 3.0;
  Scalars p;
  const Eigen::Vector2d start(std::cos(angle), std::sin(angle));
  p.x = start;
  p.value = [=](const Vector& x) {
    const double strain = x.norm() - 1.0;
    return 0.5 * stiffness * strain * strain - kPull * x[0] + 0.5 * (x - start).squaredNorm();
  };
  p.slope_of = [=](const Vector& x) {
    const double strain = x.norm() - 1.0;
    return Vector(stiffness * strain * x.normalized() + (x - start) - kPull * Vector::Unit(2, 0));
  };
  p.curvature = [=](const Vector& x) {
    const Matrix along = x * x.transpose() / x.squaredNorm();
    return Matrix((stiffness - kPull) * along + (kPull + 1.0) * Matrix::Identity(2, 2));
  };
  return p;
}

// With steps straight ahead alone 15, 30 and 64 iterations are needed.
TEST(Newton, FollowsANarrowBend) {
  for (const double stiffness : {1e3, 1e4, 1e5}) {
    Scalars p = link(stiffness, 1.0);
    p.residual_scale = 1e-8;
    NewtonSettings settings = to(1e-6);
    settings.max_iterations = 100;
    const NewtonResult r = minimise(p, settings);
    EXPECT_TRUE(r.converged) << r.failure;
    EXPECT_LE(r.iterations, 16) << stiffness;
    EXPECT_NEAR(p.x[1] / p.x[0], std::sin(1.0) / (std::cos(1.0) + 3.0), 1e-6);
  }
}

// Nothing that bold steps reach is lower: shortened ones lead to the same end.
TEST(Newton, TakesTheShortenedStepWhereBoldOnesFindNothing) {
  Scalars p = link(1e4, 1.0);
  p.residual_scale = 1e-8;
  const auto value = p.value;
  p.value = [&](const Vector& x) { return value(x) + (p.kept > p.restored ? 1e3 : 0.0); };
  NewtonSettings settings = to(1e-6);
  settings.max_iterations = 200;
  const NewtonResult r = minimise(p, settings);
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_GT(p.kept, 0);
  EXPECT_EQ(p.restored, p.kept);
  EXPECT_NEAR(p.x[1] / p.x[0], std::sin(1.0) / (std::cos(1.0) + 3.0), 1e-6);
}

// The potential is infinite beyond 0.5: the search stays this side.
TEST(Newton, LineSearchAvoidsWhatIsInadmissible) {
  Scalars p;
  p.x = Vector::Constant(1, 0.49);
  constexpr double kInf = std::numeric_limits<double>::infinity();
  p.value = [](const Vector& x) { return x[0] >= 0.5 ? kInf : -0.1 * std::log(0.5 - x[0]) - x[0]; };
  p.slope_of = [](const Vector& x) {
    return Vector(Vector::Constant(1, 0.1 / (0.5 - x[0]) - 1.0));
  };
  p.curvature = [](const Vector& x) {
    return Matrix(Matrix::Constant(1, 1, 0.1 / std::pow(0.5 - x[0], 2)));
  };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_TRUE(r.converged) << r.failure;
  EXPECT_NEAR(p.x[0], 0.4, 1e-10);
}

TEST(Newton, GoesOnAfterARevisionAndAsksAgain) {
  Scalars p = smooth(1.0, 0.7);
  int asked = 0;
  p.on_revise = [&](bool full) {
    if (!full) return false;
    if (++asked == 1) p.x[0] += 0.3;
    return asked == 1;
  };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(asked, 2);
  EXPECT_LT(p.gradient.norm(), 1e-12);
}

TEST(Newton, SaysThatIterationsRanOut) {
  Scalars p = smooth(3.0, 2.0);
  NewtonSettings settings = to(1e-10);
  settings.max_iterations = 2;
  const NewtonResult r = minimise(p, settings);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.iterations, 2);
  EXPECT_EQ(r.failure, "no convergence within 2 iterations");
}

TEST(Newton, SaysThatThePotentialIsNotFinite) {
  Scalars p = smooth(1.0, 1.0);
  p.value = [](const Vector&) { return std::nan(""); };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.failure, "the potential is not finite");
}

// A gradient with the wrong sign: nothing falls along the direction.
TEST(Newton, SaysThatTheLineSearchFoundNoDescent) {
  Scalars p;
  p.x = Vector::Constant(1, 1.0);
  p.value = [](const Vector& x) { return x[0] * x[0]; };
  p.slope_of = [](const Vector& x) { return Vector(-2.0 * x); };
  p.curvature = [](const Vector&) { return Matrix(Matrix::Constant(1, 1, 2.0)); };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_FALSE(r.converged);
  EXPECT_THAT(r.failure, ::testing::HasSubstr("line search found no descent at iteration 1"));
}

TEST(Newton, SaysThatTheProjectedMatrixIsNotDefinite) {
  Scalars p = smooth(1.0, 1.0);
  p.curvature = [](const Vector&) { return Matrix(Matrix::Constant(2, 2, std::nan(""))); };
  const NewtonResult r = minimise(p, to(1e-10));
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.failure, "the projected matrix is not positive definite");
}

// One update is Newton's from the start, and the gradient left is the model's there: none.
TEST(UpdateOnce, TakesNewtonsWholeStepAndLeavesTheModelsGradient) {
  Scalars p = smooth(0.7, -0.4);
  const Vector expected = p.x - p.curvature(p.x).ldlt().solve(p.slope_of(p.x));
  const NewtonResult r = update_once(p);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.iterations, 1);
  EXPECT_EQ(r.factorisations, 1);
  EXPECT_LT((p.x - expected).norm(), 1e-14);
  EXPECT_LT(p.gradient.norm(), 1e-14);
  EXPECT_GT(p.slope_of(p.x).norm(), 1e-3);  // which is not the potential's own
}

TEST(UpdateOnce, ProjectsAnIndefiniteMatrixAndRefusesWhatIsNotFinite) {
  Scalars p = smooth(0.7, -0.4);
  const auto curvature = p.curvature;
  p.curvature = [curvature](const Vector& x) { return Matrix(-curvature(x)); };
  const NewtonResult r = update_once(p);
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.projections, 1);
  EXPECT_EQ(r.factorisations, 2);
  p.value = [](const Vector&) { return std::numeric_limits<double>::infinity(); };
  const NewtonResult bad = update_once(p);
  EXPECT_FALSE(bad.converged);
  EXPECT_EQ(bad.failure, "the potential is not finite");
}

// Large forces that balance each other leave a small potential that is rounded coarsely: here by a
// step of 1e-9, where the way to the minimum would lower it by 5e-13. The slope still falls there.
TEST(Minimise, TakesTheWholeStepWhereTheFallDrownsInLargeForces) {
  const auto solve = [](double force) {
    Scalars p;
    p.x = Vector::Constant(1, 1e-6);
    p.value = [](const Vector& x) { return x[0] == 0.0 ? 1e-9 : 0.5 * x[0] * x[0]; };
    p.slope_of = [](const Vector& x) { return x; };
    p.curvature = [](const Vector&) { return Matrix::Identity(1, 1); };
    p.residual_scale = 1e-13;
    p.force = force;
    NewtonSettings settings;
    settings.step_tolerance = 1e-7;
    settings.round_off_step = 1e-15;
    return minimise(p, settings);
  };
  const NewtonResult known = solve(1e7);
  EXPECT_TRUE(known.converged);
  EXPECT_LE(known.iterations, 2);
  EXPECT_GT(solve(0.0).iterations, 2);
}

}  // namespace
}  // namespace retiarius

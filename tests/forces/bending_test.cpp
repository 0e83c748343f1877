#include "retiarius/forces/bending.hpp"

#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/forces/derivatives.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr double kEI = 2e-3;  // N m2

Network one_joint(Bending kind, double l1 = 0.8, double l2 = 1.1) {
  Material m = thread_material(100.0, 0.1);
  m.bending = kind;
  m.bending_stiffness = kEI;
  return chain({{0, 0, 0}, {l1, 0, 0}, {l1 + l2, 0, 0}}, m);
}

// The joint turned by phi (degrees) in a random plane, its segments stretched a little.
std::vector<Vec3> turned(const Network& net, double phi_deg, Random& random) {
  const double phi = radians(phi_deg);
  const Quat q =
      Quat(random.number(), random.number(), random.number(), random.number()).normalized();
  const Vec3 t1 = q * Vec3::UnitX();
  const Vec3 t2 = q * Vec3(std::cos(phi), std::sin(phi), 0.0);
  const Vec3 a = random.vector();
  const Vec3 b = a + net.segments[0].rest_length * (1.0 + random.number(0.1)) * t1;
  return {a, b, b + net.segments[1].rest_length * (1.0 + random.number(0.1)) * t2};
}

Step any_step(const State& start) { return make_step(Method::implicit_euler, start, 0.01); }

struct Case {
  Bending kind;
  double phi_deg;
  double tolerance;
};

class BendingDerivatives : public ::testing::TestWithParam<Case> {};

TEST_P(BendingDerivatives, AgreeWithFiniteDifferences) {
  const Case& c = GetParam();
  const Network net = one_joint(c.kind);
  Random random(7);
  BendingLaw law(net);
  State start;
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Vec3> y = turned(net, c.phi_deg, random);
    const Mismatch m = compare_derivatives(law, any_step(start), y, 1e-3);
    EXPECT_LT(m.gradient, c.tolerance);
    EXPECT_LT(m.hessian, c.tolerance);
  }
}

// 1 - cos(phi) is not what cancellation leaves of it: directions carry eps, the angle eps / phi.
TEST(Bending, EnergyOfANearlyStraightJointIsPrecise) {
  for (Bending kind : {Bending::bounded, Bending::tangent}) {
    const Network net = one_joint(kind);
    const double phi = 1e-6, lv = 0.5 * (0.8 + 1.1);
    const std::vector<Vec3> x = {
        {0, 0, 0}, {0.8, 0, 0}, {0.8 + 1.1 * std::cos(phi), 1.1 * std::sin(phi), 0}};
    const double wanted = 0.5 * kEI / lv * phi * phi;
    EXPECT_NEAR(BendingLaw(net).energy(x) / wanted, 1.0, 1e-9);
  }
}

// Bounded: smooth at every angle; truncation (1e-3)^4 / 30 times high derivatives (5! of lengths
// near 0.7) and round-off 1e-16 f / 1e-3 allow 1e-9; where the moment goes as sin(phi), near 0 and
// 180 degrees, the gradient is small against the potential's curvature and the bound widens.
// Tangent: derivatives grow with 1 / (180 - phi), so the bound widens there.
INSTANTIATE_TEST_SUITE_P(
    All, BendingDerivatives,
    ::testing::Values(Case{Bending::bounded, 0.1, 1e-7}, Case{Bending::bounded, 10.0, 1e-8},
                      Case{Bending::bounded, 60.0, 1e-9}, Case{Bending::bounded, 91.0, 1e-9},
                      Case{Bending::bounded, 135.0, 1e-9}, Case{Bending::bounded, 179.0, 1e-8},
                      Case{Bending::tangent, 0.1, 1e-7}, Case{Bending::tangent, 10.0, 1e-8},
                      Case{Bending::tangent, 60.0, 1e-9}, Case{Bending::tangent, 120.0, 1e-8},
                      Case{Bending::tangent, 170.0, 1e-4}));

// A segment far shorter than at rest, and one of no length at all, bends smoothly: derivatives as
// elsewhere, with steps that stay on one side of where the short form begins (a fifth of the rest
// length, here 0.22 m), across which only the Hessian jumps.
TEST(Bending, ShortSegmentsAreSmooth) {
  for (const Bending kind : {Bending::bounded, Bending::tangent}) {
    const Network net = one_joint(kind);
    Random random(9);
    BendingLaw law(net);
    State start;
    for (const double share : {0.0, 0.01, 0.1, 0.19, 0.21}) {
      std::vector<Vec3> y = turned(net, 70.0, random);
      y[2] = y[1] + share / 1.1 * (y[2] - y[1]);
      const Mismatch m = compare_derivatives(law, any_step(start), y, 1e-4);
      EXPECT_LT(m.gradient, 1e-6) << share;
      EXPECT_LT(m.hessian, 1e-6) << share;
    }
    std::vector<Vec3> below = turned(net, 70.0, random);
    std::vector<Vec3> above = below;
    const Vec3 t = (below[2] - below[1]).normalized();
    below[2] = below[1] + 0.2 * 1.1 * (1.0 - 1e-9) * t;
    above[2] = above[1] + 0.2 * 1.1 * (1.0 + 1e-9) * t;
    EXPECT_NEAR(law.energy(below), law.energy(above), 1e-8 * law.energy(above));
  }
}

TEST(Bending, EnergyOfAJointIsThatOfItsCurvature) {
  Random random(8);
  for (double phi_deg : {0.0, 1e-3, 5.0, 45.0, 90.0, 150.0, 179.0}) {
    const double half = 0.5 * radians(phi_deg);
    const double lv = 0.5 * (0.8 + 1.1);
    const Network bounded = one_joint(Bending::bounded);
    const Network tangent = one_joint(Bending::tangent);
    const std::vector<Vec3> y = turned(bounded, phi_deg, random);
    // 1 - cos(phi) is known to 1e-16: absolutely, so is the energy over EI / lv.
    const double wanted_bounded = 0.5 * kEI / lv * std::pow(2.0 * std::sin(half), 2);
    const double wanted_tangent = 0.5 * kEI / lv * std::pow(2.0 * std::tan(half), 2);
    EXPECT_NEAR(BendingLaw(bounded).energy(y), wanted_bounded, 1e-15 * kEI / lv);
    // Near 180 degrees 1 + cos(phi), some 1.5e-4, carries the round-off: relative 1e-11.
    EXPECT_NEAR(BendingLaw(tangent).energy(y), wanted_tangent,
                1e-15 * kEI / lv + 1e-11 * wanted_tangent);
  }
}

// A folded thread: the bounded energy is 1/2 (EI / lv) 4, the tangent one infinite.
// EI phi^2 / 2 l_v to the rounding of the places, where 1 - cos(phi) is itself below rounding.
TEST(Bending, EnergyOfTheSmallestTurnsIsNotLostInRounding) {
  for (Bending kind : {Bending::bounded, Bending::tangent}) {
    const Network net = one_joint(kind, 1.0, 1.0);
    const double phi = 1e-9;
    const std::vector<Vec3> y = {{-1, 0, 0}, {0, 0, 0}, {std::cos(phi), std::sin(phi), 0}};
    EXPECT_NEAR(BendingLaw(net).energy(y) / (0.5 * kEI * phi * phi), 1.0, 1e-6);
  }
}

TEST(Bending, FoldedThreads) {
  const Network net = one_joint(Bending::bounded, 1.0, 1.0);
  const std::vector<Vec3> folded{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_DOUBLE_EQ(BendingLaw(net).energy(folded), 2.0 * kEI);
  EXPECT_EQ(BendingLaw(one_joint(Bending::tangent, 1.0, 1.0)).energy(folded), kInfinity);
  State start;
  BendingLaw law(net);
  for (const Vec3& g : gradient_of(law, any_step(start), folded)) EXPECT_NEAR(g.norm(), 0.0, 1e-15);
}

TEST(Bending, DefiniteBlocksAreSemidefiniteAndElseTheFullOnes) {
  Random random(9);
  State start;
  int projected = 0, equal = 0;
  for (Bending kind : {Bending::bounded, Bending::tangent}) {
    const Network net = one_joint(kind);
    BendingLaw law(net);
    for (double phi_deg : {0.0, 1.0, 30.0, 80.0, 120.0, 170.0, 179.0}) {
      const std::vector<Vec3> y = turned(net, phi_deg, random);
      const Eigen::MatrixXd full = hessian_of(law, any_step(start), y, false);
      const Eigen::MatrixXd definite = hessian_of(law, any_step(start), y, true);
      const double scale = full.cwiseAbs().maxCoeff();
      EXPECT_GE(smallest_eigenvalue(definite), -1e-13 * scale) << phi_deg;
      if (smallest_eigenvalue(full) >= -1e-14 * scale) {
        ++equal;
        EXPECT_LE((full - definite).cwiseAbs().maxCoeff(), 1e-12 * scale) << phi_deg;
      } else {
        ++projected;
      }
    }
  }
  EXPECT_GE(projected, 4);
  EXPECT_GE(equal, 1);
}

TEST(Bending, InternalForcesHaveNoResultant) {
  Random random(10);
  State start;
  for (Bending kind : {Bending::bounded, Bending::tangent}) {
    const Network net = one_joint(kind);
    BendingLaw law(net);
    const std::vector<Vec3> y = turned(net, 100.0, random);
    const std::vector<Vec3> g = gradient_of(law, any_step(start), y);
    const Vec3 force = g[0] + g[1] + g[2];
    const Vec3 torque = y[0].cross(g[0]) + y[1].cross(g[1]) + y[2].cross(g[2]);
    const double scale = g[0].norm() + g[1].norm() + g[2].norm();
    EXPECT_LT(force.norm(), 1e-15 * scale);
    EXPECT_LT(torque.norm(), 1e-14 * scale);  // arms of a few metres
  }
}

TEST(Bending, OrderOfNodeNumbersDoesNotMatter) {
  // The same joint numbered backwards and scrambled: the blocks land on the right pairs.
  Random random(11);
  State start;
  const Network net = one_joint(Bending::bounded);
  const std::vector<Vec3> y = turned(net, 70.0, random);
  for (const auto& order : {std::array<Index, 3>{2, 1, 0}, {1, 0, 2}, {2, 0, 1}, {0, 2, 1}}) {
    Network other = net;
    std::vector<Vec3> moved(3);
    for (int k = 0; k < 3; ++k) moved[order[k]] = y[k];
    Joint& j = other.joints[0];
    j.a = order[0];
    j.b = order[1];
    j.c = order[2];
    BendingLaw law(other);
    const Mismatch m = compare_derivatives(law, any_step(start), moved, 1e-3);
    EXPECT_LT(m.hessian, 1e-8);
  }
}

TEST(Bending, CurvatureAtNodes) {
  Random random(12);
  const Network net = one_joint(Bending::bounded);
  const std::vector<double> k = node_curvatures(net, turned(net, 60.0, random));
  EXPECT_EQ(k[0], 0.0);
  EXPECT_NEAR(k[1], 2.0 * std::sin(radians(30.0)) / 0.95, 1e-12);
  EXPECT_EQ(k[2], 0.0);
}

}  // namespace
}  // namespace retiarius

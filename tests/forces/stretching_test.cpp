#include "retiarius/forces/stretching.hpp"

#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "tests/forces/derivatives.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr double kEA = 300.0;  // N
constexpr double kH = 0.01;    // s

Network four_nodes(bool compression, double tau) {
  Material m = thread_material(kEA, 0.1);
  m.compression = compression;
  m.damping = tau;
  return chain({{0, 0, 0}, {1, 0.2, 0}, {1.8, -0.3, 0.4}, {2.5, 0.3, 0.1}}, m);
}

State random_state(const Network& net, Random& random, double displacement, double speed) {
  State s;
  s.x = random.disturbed(net.initial, displacement);
  for (std::size_t i = 0; i < s.x.size(); ++i) s.v.push_back(random.vector(speed));
  return s;
}

struct Case {
  Method method;
  bool compression;
  double tau;
};

class StretchingDerivatives : public ::testing::TestWithParam<Case> {};

// Displacements of 5 % strain the segments both ways; the potential is smooth away from eps = 0 for
// tension-only threads, where a state whose differences straddle the kink is drawn anew.
TEST_P(StretchingDerivatives, AgreeWithFiniteDifferences) {
  const Case& c = GetParam();
  const Network net = four_nodes(c.compression, c.tau);
  Random random(1);
  int compared = 0;
  double worst_gradient = 0.0, worst_hessian = 0.0;
  for (int trial = 0; trial < 200 && compared < 30; ++trial) {
    const State start = random_state(net, random, 0.05, 1.0);
    const Step step = make_step(c.method, start, kH);
    Stretching law(net);
    law.prepare(step);
    const std::vector<Vec3> y = random.disturbed(start.x, 0.05);
    // Differences reach 2e-4 m along an axis: strains change by less than 1e-3.
    bool kink = false, taut = false;
    for (std::size_t k = 0; k < net.segments.size(); ++k) {
      const Segment& s = net.segments[k];
      const double stretched = axial_strain(y[s.a], y[s.b], s.rest_length);
      const double t = law.tensions(y)[k];
      kink |= !c.compression && std::abs(stretched) < 2e-3;
      kink |= !c.compression && t < 2e-3 * kEA * (1.0 + 2.0 * c.tau / kH) && stretched > 0.0;
      taut |= t != 0.0;
    }
    if (kink || !taut) continue;
    ++compared;
    const Mismatch m = compare_derivatives(law, step, y, 1e-4);
    worst_gradient = std::max(worst_gradient, m.gradient);
    worst_hessian = std::max(worst_hessian, m.hessian);
  }
  EXPECT_GE(compared, 10);
  // Potential up to EA l0 eps^2 ~ 30 J against forces of 30 N: round-off 1e-15 / 1e-4 = 1e-11.
  EXPECT_LT(worst_gradient, 1e-9);
  EXPECT_LT(worst_hessian, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    All, StretchingDerivatives,
    ::testing::Values(
        Case{Method::implicit_euler, true, 0.0}, Case{Method::implicit_euler, true, 0.02},
        Case{Method::newmark, true, 0.02}, Case{Method::midpoint, true, 0.02},
        Case{Method::generalised_alpha, true, 0.02}, Case{Method::generalised_alpha, false, 0.02},
        Case{Method::static_solve, true, 0.02}, Case{Method::implicit_euler, false, 0.0},
        Case{Method::implicit_euler, false, 0.02}, Case{Method::newmark, false, 0.02},
        Case{Method::midpoint, false, 0.02}, Case{Method::static_solve, false, 0.02}));

TEST(Stretching, TwoNodesPullWithEAStrain) {
  const Network net = chain({{0, 0, 0}, {2, 0, 0}}, thread_material(kEA, 0.1));
  State start;
  start.x = net.initial;
  start.v = net.velocity;
  const Step step = make_step(Method::implicit_euler, start, kH);
  Stretching law(net);
  law.prepare(step);
  const std::vector<Vec3> y{{0, 0, 0}, {0, 2.1, 0}};
  const std::vector<Vec3> g = gradient_of(law, step, y);
  EXPECT_NEAR((g[1] - Vec3(0, 0.05 * kEA, 0)).norm(), 0.0, 1e-12 * kEA);
  EXPECT_NEAR((g[0] + g[1]).norm(), 0.0, 1e-15);
  EXPECT_NEAR(law.energy(y), 0.5 * kEA * 2.0 * 0.05 * 0.05, 1e-12);
  EXPECT_NEAR(law.tensions(y)[0], 0.05 * kEA, 1e-12);
}

// Kelvin-Voigt: T = EA (eps + tau deps/dt). Constant rate of extension v / l0.
TEST(Stretching, ViscousTensionOfAPulledSegment) {
  for (Method method :
       {Method::implicit_euler, Method::newmark, Method::midpoint, Method::generalised_alpha}) {
    const double tau = 0.03, v = 0.4, l0 = 2.0;
    Material m = thread_material(kEA, 0.1);
    m.damping = tau;
    const Network net = chain({{0, 0, 0}, {l0, 0, 0}}, m);
    State start;
    start.x = {{0, 0, 0}, {2.1, 0, 0}};
    start.v = {{0, 0, 0}, {v, 0, 0}};
    const Step step = make_step(method, start, kH);
    Stretching law(net);
    law.prepare(step);
    const std::vector<Vec3> y = first_guess(method, step);  // at constant velocity
    const double eps = y[1].x() / l0 - 1.0;
    EXPECT_NEAR(law.tensions(y)[0], kEA * (eps + tau * v / l0), 1e-11 * kEA) << to_string(method);
  }
}

// The rate at the start itself, from the velocities: what Newmark's start acceleration needs.
TEST(Stretching, TensionAtTheStartCountsItsVelocity) {
  Material m = thread_material(kEA, 0.1);
  m.damping = 0.03;
  const Network net = chain({{0, 0, 0}, {2, 0, 0}}, m);
  State start;
  start.x = {{0, 0, 0}, {0, 0, 2.1}};
  start.v = {{0, 0, 0.1}, {5, 0, 0.5}};
  Step step;
  step.start = &start;
  step.carry = -1.0;
  step.strain_rate = Step::StrainRate::start;
  Stretching law(net);
  law.prepare(step);
  EXPECT_NEAR(law.tensions(start.x)[0], kEA * (0.05 + 0.03 * 0.4 / 2.0), 1e-11 * kEA);
}

// T of a tension-only thread has no jump (steps of 1e-7 in strain change it by no more than the
// slope allows), is never negative, and the potential is convex in the strain.
TEST(Stretching, TensionOnlyIsContinuousAndConvex) {
  Random random(3);
  for (Method method :
       {Method::implicit_euler, Method::newmark, Method::midpoint, Method::generalised_alpha}) {
    const Network net = four_nodes(false, 0.02);
    for (int trial = 0; trial < 50; ++trial) {
      const State start = random_state(net, random, 0.03, 2.0);
      const Step step = make_step(method, start, kH);
      Stretching law(net);
      law.prepare(step);
      const std::vector<Vec3> from = random.disturbed(start.x, 0.2);
      const std::vector<Vec3> to = random.disturbed(start.x, 0.2);
      const auto at = [&](double s) {
        std::vector<Vec3> y = from;
        for (std::size_t i = 0; i < y.size(); ++i) y[i] += s * (to[i] - from[i]);
        return y;
      };
      constexpr int kSamples = 400;
      std::vector<double> before = law.tensions(from);
      std::vector<double> value;
      for (int k = 0; k <= kSamples; ++k) {
        const std::vector<Vec3> y = at(static_cast<double>(k) / kSamples);
        value.push_back(law.potential(step, y));
        const std::vector<double> t = law.tensions(y);
        for (std::size_t s = 0; s < t.size(); ++s) {
          ASSERT_GE(t[s], 0.0);
          // Strains change by at most |to - from| sqrt(2) / (l0 samples) < 3e-3 a sample.
          ASSERT_LE(std::abs(t[s] - before[s]), 3e-3 * kEA * (1.0 + 2.0 * 0.02 / kH));
        }
        before = t;
      }
      // Convex along a line in positions: l is convex in y and T is nondecreasing and >= 0.
      const double noise = 1e-13 * (1.0 + *std::max_element(value.begin(), value.end()));
      for (int k = 1; k < kSamples; ++k)
        ASSERT_GE(value[k - 1] + value[k + 1] - 2.0 * value[k], -noise);
    }
  }
}

TEST(Stretching, DefiniteBlocksAreSemidefiniteAndElseTheFullOnes) {
  Random random(4);
  int projected = 0, equal = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Network net = chain({{0, 0, 0}, {1, 0.2, 0}}, thread_material(kEA, 0.1));
    State start = random_state(net, random, 0.1, 1.0);
    const Step step = make_step(Method::implicit_euler, start, kH);
    Stretching law(net);
    law.prepare(step);
    const Eigen::MatrixXd full = hessian_of(law, step, start.x, false);
    const Eigen::MatrixXd definite = hessian_of(law, step, start.x, true);
    const double scale = full.cwiseAbs().maxCoeff();
    EXPECT_GE(smallest_eigenvalue(definite), -1e-13 * scale);
    if (smallest_eigenvalue(full) >= -1e-13 * scale) {
      ++equal;
      EXPECT_LE((full - definite).cwiseAbs().maxCoeff(), 1e-13 * scale);
    } else {
      ++projected;
    }
  }
  EXPECT_GT(projected, 10);
  EXPECT_GT(equal, 10);
}

TEST(Stretching, InternalForcesHaveNoResultant) {
  Random random(5);
  const Network net = four_nodes(true, 0.02);
  const State start = random_state(net, random, 0.1, 2.0);
  for (Method method :
       {Method::implicit_euler, Method::newmark, Method::midpoint, Method::generalised_alpha}) {
    const Step step = make_step(method, start, kH);
    Stretching law(net);
    law.prepare(step);
    const std::vector<Vec3> y = random.disturbed(start.x, 0.1);
    const std::vector<Vec3> g = gradient_of(law, step, y);
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    double scale = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      force += g[i];
      torque += y[i].cross(g[i]);
      scale += g[i].norm();
    }
    EXPECT_LT(force.norm(), 1e-14 * scale);   // additions of round-off
    EXPECT_LT(torque.norm(), 1e-14 * scale);  // arms of a few metres
  }
}

// A segment that closes to nothing does not poison the step with NaN.
TEST(Stretching, ASegmentOfNoLengthStaysFinite) {
  const Network net = chain({{0, 0, 0}, {1, 0, 0}}, thread_material(kEA, 0.1));
  State start;
  start.x = net.initial;
  start.v = net.velocity;
  const Step step = make_step(Method::implicit_euler, start, kH);
  Stretching law(net);
  law.prepare(step);
  const std::vector<Vec3> y{{0.5, 0, 0}, {0.5, 0, 0}};
  EXPECT_TRUE(std::isfinite(law.potential(step, y)));
  EXPECT_TRUE(hessian_of(law, step, y, true).allFinite());
  EXPECT_TRUE(gradient_of(law, step, y)[0].allFinite());
}

// What awaken() adds where one segment is slack at y and taut at `next`: the gradient of the same
// thread with compression, and of its Hessian what lies along the segment.
TEST(Stretching, AwakensWhatBecomesTaut) {
  Random random(5);
  int awakened = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Network net = four_nodes(false, 0.0), both = four_nodes(true, 0.0);
    const State start = random_state(net, random, 0.05, 1.0);
    const Step step = make_step(Method::implicit_euler, start, kH);
    Stretching law(net), bilateral(both);
    law.prepare(step);
    bilateral.prepare(step);
    const std::vector<Vec3> y = random.disturbed(start.x, 0.05);
    const std::vector<Vec3> next = random.disturbed(y, 0.05);
    const std::vector<double> now = law.tensions(y), then = law.tensions(next);
    double energy = 0.0;
    std::vector<Vec3> expected(y.size(), Vec3::Zero());
    for (std::size_t k = 0; k < net.segments.size(); ++k) {
      if (now[k] > 0.0 || then[k] == 0.0) continue;
      const Segment& s = net.segments[k];
      energy += 0.5 * then[k] * then[k] * s.rest_length / kEA;
      const Vec3 t = (y[s.b] - y[s.a]).normalized();
      expected[s.b] += bilateral.tensions(y)[k] * t;
      expected[s.a] -= bilateral.tensions(y)[k] * t;
    }
    EXPECT_NEAR(law.awaken(y, next, nullptr), energy, 1e-12 * (1.0 + energy));
    BlockPattern pattern(static_cast<Index>(y.size()));
    BlockMatrix hessian = empty_hessian(law, pattern);
    std::vector<Vec3> gradient(y.size(), Vec3::Zero());
    const Assembly out{&gradient, &hessian, false};
    EXPECT_NEAR(law.awaken(y, next, &out), energy, 1e-12 * (1.0 + energy));
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR((gradient[i] - expected[i]).norm(), 0.0, 1e-12 * kEA);
    // Moved by d, the awakened resist with EA / l0 times the change of length, to first order.
    const std::vector<Vec3> d = random.disturbed(std::vector<Vec3>(y.size(), Vec3::Zero()), 1.0);
    std::vector<Vec3> product;
    hessian.multiply(d, product);
    double work = 0.0, along = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) work += d[i].dot(product[i]);
    for (std::size_t k = 0; k < net.segments.size(); ++k) {
      if (now[k] > 0.0 || then[k] == 0.0) continue;
      const Segment& s = net.segments[k];
      const double longer = (y[s.b] - y[s.a]).normalized().dot(d[s.b] - d[s.a]);
      along += kEA / s.rest_length * longer * longer;
      ++awakened;
    }
    EXPECT_NEAR(work, along, 1e-11 * (1.0 + along));
    EXPECT_EQ(bilateral.awaken(y, next, nullptr), 0.0);
  }
  EXPECT_GT(awakened, 50);
}

// After foretell(y, next) potential and gradient are as before; across a taut segment the Hessian
// has the tension that the linearisation at y gives at `next`, and segments that are a little slack
// although they were foretold a tension are held as if they were taut. (At `next` itself there are
// none of these: lengths are convex.)
TEST(Stretching, ForetellsTensionsAndHoldsWhatIsToBeTaut) {
  Random random(6);
  int taut = 0, held = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Network net = four_nodes(false, 0.0);
    const State start = random_state(net, random, 1e-3, 1.0);
    const Step step = make_step(Method::implicit_euler, start, kH);
    Stretching law(net), plain(net);
    law.prepare(step);
    plain.prepare(step);
    const std::vector<Vec3> y = random.disturbed(start.x, 1e-3);
    const std::vector<Vec3> next = random.disturbed(y, 2e-3), z = random.disturbed(next, 1e-3);
    law.foretell(y, next);
    EXPECT_EQ(law.potential(step, z), plain.potential(step, z));
    EXPECT_EQ(gradient_of(law, step, z), gradient_of(plain, step, z));
    BlockPattern pattern(static_cast<Index>(y.size()));
    BlockMatrix hessian = empty_hessian(law, pattern);
    std::vector<Vec3> gradient(y.size(), Vec3::Zero()), pulls(y.size(), Vec3::Zero());
    Assembly all{&gradient, &hessian, false};
    law.assemble(step, z, all);
    const bool any = law.hold(z, {&pulls, &hessian, false});
    const std::vector<Vec3> d = random.disturbed(std::vector<Vec3>(y.size(), Vec3::Zero()), 1.0);
    std::vector<Vec3> product;
    hessian.multiply(d, product);
    double work = 0.0, expected = 0.0;
    std::vector<Vec3> pulled(y.size(), Vec3::Zero());
    bool holds = false;
    for (std::size_t i = 0; i < y.size(); ++i) work += d[i].dot(product[i]);
    for (const Segment& s : net.segments) {
      const Vec3 before = y[s.b] - y[s.a], then = next[s.b] - next[s.a];
      const Vec3 now = z[s.b] - z[s.a];
      const double was = before.norm() / s.rest_length - 1.0;
      const double is = now.norm() / s.rest_length - 1.0;
      const double linear = was + (then - before).dot(before.normalized()) / s.rest_length;
      const double tension = was >= 0.0 ? std::max(0.0, kEA * linear) : 0.0;
      const Vec3 t = now.normalized(), ways = d[s.b] - d[s.a];
      if (is < 0.0) {
        if (tension == 0.0 || is < -1e-3) continue;
        holds = true;
        ++held;
        pulled[s.b] += kEA * is * t;
        pulled[s.a] -= kEA * is * t;
      }
      ++taut;
      const double along = ways.dot(t);
      expected += kEA / s.rest_length * along * along;
      expected += tension / now.norm() * (ways.squaredNorm() - along * along);
    }
    EXPECT_EQ(any, holds);
    EXPECT_NEAR(work, expected, 1e-9 * (1.0 + expected));
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR((pulls[i] - pulled[i]).norm(), 0.0, 1e-9 * kEA);
    EXPECT_EQ(law.awaken(z, z, nullptr), 0.0);
    law.prepare(step);
    EXPECT_EQ(hessian_of(law, step, z, false), hessian_of(plain, step, z, false));
  }
  EXPECT_GT(taut, 100);
  EXPECT_GT(held, 10);
}

TEST(Stretching, RelaxesAGuessThatOverstretches) {
  const Network net = four_nodes(false, 0.0);
  State start;
  start.x = net.initial;
  start.v = net.velocity;
  const Step step = make_step(Method::implicit_euler, start, kH);
  const Stretching law(net);
  const std::vector<bool> held{true, false, false, false};
  std::vector<Vec3> y = net.initial;
  y[3] += Vec3(0.5, 0.2, 0.1);
  y[1] += Vec3(0.1, 0.0, 0.0);
  law.relax(step, {&net.mass, &held}, y);
  EXPECT_EQ(y[0], net.initial[0]);
  for (const Segment& s : net.segments)
    EXPECT_LT(axial_strain(y[s.a], y[s.b], s.rest_length), 3e-3);

  // Two free masses that are drawn apart come together about their mass centre.
  Network pair = chain({{0, 0, 0}, {1, 0, 0}}, net.materials.front());
  pair.mass = {1.0, 3.0};
  start.x = pair.initial;
  start.v = pair.velocity;
  y = {{-0.1, 0, 0}, {1.1, 0.0, 0}};
  const std::vector<bool> both_free{false, false};
  Stretching(pair).relax(make_step(Method::implicit_euler, start, kH), {&pair.mass, &both_free}, y);
  EXPECT_NEAR((y[0] + 3.0 * y[1]).x(), 3.2, 1e-12);
  EXPECT_NEAR((y[1] - y[0]).x(), 1.001, 1e-12);

  // What is slack stays as it is, whether it bears compression or not; what is too long does not.
  y = {{0, 0, 0}, {0.9, 0, 0}};
  Stretching(pair).relax(step, {&pair.mass, &both_free}, y);
  EXPECT_EQ(y[1].x(), 0.9);
  EXPECT_TRUE(Stretching(pair).one_sided());
  pair.materials.front().compression = true;
  EXPECT_FALSE(Stretching(pair).one_sided());
  Stretching(pair).relax(step, {&pair.mass, &both_free}, y);
  EXPECT_EQ(y[1].x(), 0.9);
  y = {{0, 0, 0}, {1.2, 0, 0}};
  Stretching(pair).relax(step, {&pair.mass, &both_free}, y);
  EXPECT_NEAR((y[1] - y[0]).x(), 1.001, 1e-12);
}

}  // namespace
}  // namespace retiarius

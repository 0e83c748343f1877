// Steps that follow the local error.
#include <algorithm>

#include <gtest/gtest.h>

#include "retiarius/motion/integrator.hpp"
#include "retiarius/motion/local_error.hpp"
#include "tests/motion/advance.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

constexpr Method kAdaptive[] = {Method::implicit_euler, Method::newmark, Method::midpoint,
                                Method::generalised_alpha, Method::tr_bdf2};
const std::vector<Body> kNoBodies;
const EnvironmentSpec kGravity{{0, 0, -4}, 0.0};

IntegratorSpec adaptive(Method method, double accuracy, double largest) {
  IntegratorSpec spec;
  spec.method = method;
  spec.adaptive = true;
  spec.accuracy = accuracy;
  spec.step = largest;
  spec.tolerance = 1e-11;
  return spec;
}

IntegratorSpec fixed(Method method) {
  IntegratorSpec spec;
  spec.method = method;
  spec.tolerance = 1e-11;
  return spec;
}

// A soft chain with bending that swings about its held end.
Network swinging() {
  Material m = thread_material(60.0, 0.1);
  m.bending = Bending::bounded;
  m.bending_stiffness = 0.3;
  return straight_chain(6, 1.5, m);
}

double rms(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

int advance_to(Simulation& sim, double end, const PrescribedMotion& motion) {
  int steps = 0;
  for (; sim.state().time < end; ++steps) sim.advance(end, motion);
  return steps;
}

TEST(LocalError, StepsFollowTheOrder) {
  EXPECT_DOUBLE_EQ(fitting_step(0.1, 1.0, 2, 2.0), 0.09);
  EXPECT_NEAR(fitting_step(0.1, 4.0, 2, 2.0), 0.045, 1e-15);
  EXPECT_NEAR(fitting_step(0.1, 8.0, 3, 2.0), 0.045, 1e-15);
  EXPECT_DOUBLE_EQ(fitting_step(0.1, 1e-9, 3, 2.0), 0.2);  // growth is limited
  EXPECT_DOUBLE_EQ(fitting_step(0.1, 0.0, 3, 2.0), 0.2);
  EXPECT_DOUBLE_EQ(fitting_step(0.1, 1e9, 3, 2.0), 0.02);
}

TEST(LocalError, GrowthIsLimitedByWhatGeneralisedAlphaRemembers) {
  IntegratorSpec spec;
  EXPECT_EQ(most_growth(spec), 2.0);
  spec.method = Method::generalised_alpha;
  // alpha_m / (1 - alpha_m) = 0.8 / 1.1.
  EXPECT_NEAR(most_growth(spec), 0.98 * std::sqrt(1.1 / 0.8), 1e-12);
  spec.rho = 0.5;  // forgets at once
  EXPECT_EQ(most_growth(spec), 2.0);
  spec.rho = 1.0;  // never forgets
  EXPECT_EQ(most_growth(spec), 1.02);
}

// Halved, a smooth motion's error of third order falls eightfold, a kink's about twofold.
TEST(LocalError, AKinkGainsLittleFromShorterSteps) {
  EXPECT_FALSE(at_kink(0.1, 8.0, 0.05, 1.0, 3));
  EXPECT_FALSE(at_kink(0.1, 8.0, 0.05, 2.8, 3));
  EXPECT_TRUE(at_kink(0.1, 8.0, 0.05, 4.0, 3));
}

TEST(LocalError, NoSliverIsLeftBeforeTheEnd) {
  EXPECT_EQ(part_of(1.0, 1.0), 1.0);
  EXPECT_EQ(part_of(1.00005, 1.0), 1.00005);
  EXPECT_EQ(part_of(1.2, 1.0), 0.6);
  EXPECT_EQ(part_of(5.0, 1.0), 1.0);
}

// The estimate of every accepted step against what that step really did wrong, which a run of 40
// short steps from the same state tells. The leading term is right to a few per cent for short
// steps; here steps are as long as the accuracy lets them.
TEST(Adaptive, TheEstimateIsTheErrorOnASmoothSwing) {
  const Network net = swinging();
  const PrescribedMotion held = hold(net.initial, {0});
  for (Method method : kAdaptive) {
    constexpr double kAccuracy = 1e-5;
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure(kGravity, adaptive(method, kAccuracy, 0.02), {});
    std::vector<double> ratios;
    while (sim.state().time < 0.5) {
      const State before = sim.state();
      const StepReport report = sim.advance(0.5, held);
      EXPECT_LE(report.error, 1.0) << to_string(method) << " at " << before.time;
      Simulation fine(net, kNoBodies, before);
      fine.configure(kGravity, fixed(Method::midpoint), {});
      run(fine, report.h / 40.0, 40, held);
      const double length = median_rest_length(net);
      const double error = rms(fine.state().x, sim.state().x) / length / kAccuracy;
      if (report.error > 0.2) ratios.push_back(error / report.error);
    }
    ASSERT_GT(ratios.size(), 10u) << to_string(method);
    std::sort(ratios.begin(), ratios.end());
    const double median = ratios[ratios.size() / 2];
    EXPECT_GT(median, 0.5) << to_string(method);
    EXPECT_LT(median, 2.0) << to_string(method);
    EXPECT_LT(ratios.back(), 6.0) << to_string(method);
  }
}

// The error at the end is about the number of steps times what each may do wrong.
TEST(Adaptive, TheWholeErrorFollowsTheAccuracyAsked) {
  const Network net = swinging();
  const PrescribedMotion held = hold(net.initial, {0});
  Simulation exact(net, kNoBodies, initial_state(net, kNoBodies));
  exact.configure(kGravity, fixed(Method::midpoint), {});
  run(exact, 5e-5, 10000, held);
  for (Method method : kAdaptive) {
    for (double accuracy : {1e-4, 1e-5}) {
      Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
      sim.configure(kGravity, adaptive(method, accuracy, 0.05), {});
      const int steps = advance_to(sim, 0.5, held);
      const double error =
          rms(exact.state().x, sim.state().x) / median_rest_length(net) / (steps * accuracy);
      EXPECT_LT(error, 10.0) << to_string(method) << " " << accuracy;
      EXPECT_GT(error, 0.05) << to_string(method) << " " << accuracy;
    }
  }
}

// A folded thread with a mass at its end that is thrown: it flies free, snaps taut segment after
// segment, and bounces.
Network folded() {
  Material m = thread_material(2000.0, 0.02);
  m.compression = false;
  Network net = straight_chain(8, 1.6, m);
  net.mass.back() += 0.2;
  for (std::size_t i = 0; i < net.initial.size(); ++i)
    net.initial[i] = Vec3(0.02 * static_cast<double>(i), i % 2 == 0 ? 0.0 : 0.19, 0.0);
  net.velocity.back() = Vec3(4.0, 0.0, 0.5);
  return net;
}

// As many fixed steps as the adaptive run took, rejected ones included, leave a larger error: those
// that reach the same need more. Snaps make each run's error a matter of chance (rounding moves it
// by a third), so the means over five accuracies are compared. Generalised alpha is left out: on
// threads that snap it makes energy with steps that change.
TEST(Adaptive, NeedsFewerStepsThanFixedOnesOnAShotWithSnaps) {
  const Network net = folded();
  const PrescribedMotion held = hold(net.initial, {0});
  constexpr double kTime = 0.45;
  Simulation exact(net, kNoBodies, initial_state(net, kNoBodies));
  exact.configure({}, fixed(Method::midpoint), {});
  run(exact, 5e-6, 90000, held);
  for (Method method : {Method::implicit_euler, Method::newmark, Method::tr_bdf2}) {
    double error = 0.0, even_error = 0.0;
    for (double accuracy : {0.8e-3, 0.9e-3, 1e-3, 1.1e-3, 1.2e-3}) {
      Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
      sim.configure({}, adaptive(method, accuracy, 0.02), {});
      int steps = 0, rejected = 0;
      while (sim.state().time < kTime) {
        const StepReport report = sim.advance(kTime, held);
        EXPECT_LE(report.rejections, 4);
        EXPECT_GE(report.h, 0.02e-3 * 0.49);
        ++steps;
        rejected += report.rejections;
      }
      error += 0.2 * rms(exact.state().x, sim.state().x);
      Simulation even(net, kNoBodies, initial_state(net, kNoBodies));
      even.configure({}, fixed(method), {});
      run(even, kTime / (steps + rejected), steps + rejected, held);
      even_error += 0.2 * rms(exact.state().x, even.state().x);
    }
    RecordProperty(to_string(method), std::to_string(error) + " / " + std::to_string(even_error));
    EXPECT_LT(error, even_error) << to_string(method);
  }
}

// All that steers is in the state: a run that goes on from a copy of it does the same bit for bit.
TEST(Adaptive, GoesOnFromAStateBitForBit) {
  const Network net = folded();
  const PrescribedMotion held = hold(net.initial, {0});
  for (Method method : kAdaptive) {
    Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
    sim.configure({{0, 0, -1}, 0.1}, adaptive(method, 1e-3, 0.02), {});
    advance_to(sim, 0.2, held);
    Simulation again(net, kNoBodies, sim.state());
    again.configure({{0, 0, -1}, 0.1}, adaptive(method, 1e-3, 0.02), {});
    advance_to(sim, 0.4, held);
    advance_to(again, 0.4, held);
    EXPECT_EQ(sim.state().step, again.state().step) << to_string(method);
    EXPECT_EQ(sim.state().x, again.state().x) << to_string(method);
    EXPECT_EQ(sim.state().v, again.state().v) << to_string(method);
  }
}

// After a kick, or in other surroundings, generalised alpha starts up anew: what it remembers is
// the acceleration in the state that it is now in.
TEST(GeneralisedAlpha, StartsUpAfterAKickAndInNewSurroundings) {
  const Network net = swinging();
  Simulation sim(net, kNoBodies, initial_state(net, kNoBodies));
  sim.configure({{0, 0, -4}, 0.0}, fixed(Method::generalised_alpha), {});
  sim.advance(0.01, {});
  ASSERT_EQ(sim.state().memory.acceleration.size(), net.mass.size());
  EXPECT_NEAR(sim.state().memory.acceleration[2].z(), -4.0, 1e-9);
  EXPECT_NEAR(sim.state().memory.outside_force.z(), -4.0 * total_mass(net), 1e-12);
  sim.kick(2, {0, 0, 1});
  EXPECT_TRUE(sim.state().memory.acceleration.empty());
  sim.advance(0.02, {});
  ASSERT_FALSE(sim.state().memory.acceleration.empty());
  sim.configure({{0, 0, -4}, 0.0}, fixed(Method::generalised_alpha), {});
  EXPECT_FALSE(sim.state().memory.acceleration.empty());
  sim.configure({{0, 0, -3}, 0.0}, fixed(Method::generalised_alpha), {});
  EXPECT_TRUE(sim.state().memory.acceleration.empty());
}

}  // namespace
}  // namespace retiarius

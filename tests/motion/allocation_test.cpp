// A step takes no memory that the steps before it did not have.
#include <gtest/gtest.h>

#include "tests/contact/scene.hpp"
#include "tests/motion/flying_net.hpp"
#include "tests/solve/counted_new.hpp"

namespace retiarius {
namespace {

using namespace retiarius::testing;

// Allocations of the last of some steps of 2 ms.
long allocations_of_a_step(Simulation& sim, int steps) {
  long before = 0;
  for (int k = 1; k <= steps; ++k) {
    before = allocations;
    sim.advance(0.002 * k, {});
  }
  return allocations - before;
}

TEST(StepAllocation, IsCounted) {
  const long before = allocations;
  const std::vector<Vec3> x(100);
  EXPECT_GT(allocations, before) << "the counting operator new is not in use";
  EXPECT_EQ(x.size(), 100u);
}

TEST(StepAllocation, ImplicitStepsDoNone) {
  const std::vector<Body> none;
  for (const bool compression : {true, false}) {
    const Network net = flying_net(Pattern::square, 4, compression, 1e-5, 0.02);
    for (const Newton newton : {Newton::converged, Newton::single}) {
      if (newton == Newton::single && !compression) continue;
      IntegratorSpec spec = with(Method::implicit_euler);
      spec.newton = newton;
      Simulation sim(net, none, initial_state(net, none));
      sim.configure({{0, 0, -9.81}, 0.1}, spec, {});
      EXPECT_EQ(allocations_of_a_step(sim, 10), 0) << compression;
    }
  }
}

TEST(StepAllocation, ExplicitStepsDoNone) {
  const Network net = flying_net(Pattern::square, 2, false, 1e-5, 0.0);
  const std::vector<Body> ball{sphere(0.35, 0.0, {0.05, 0.02, 0.4}, BodyMotion::fixed)};
  for (const std::vector<Body>& bodies : {std::vector<Body>{}, ball}) {
    Simulation sim(net, bodies, initial_state(net, bodies));
    sim.configure({}, with(Method::explicit_differences), {ContactMethod::modified_mass, 0.3});
    EXPECT_EQ(allocations_of_a_step(sim, 60), 0) << bodies.size();
    if (!bodies.empty()) {
      EXPECT_GT(sim.state().touches.size(), 4u);
    }
  }
}

// A free ball is caught; the step that is counted has contacts, but not the most so far.
TEST(StepAllocation, ContactStepsDoNone) {
  const Network net = flying_net(Pattern::square, 2, false, 1e-5, 0.0);
  const std::vector<Body> ball{sphere(0.35, 5.0, {0.05, 0.02, 0.4}, BodyMotion::free)};
  for (const ContactMethod method : {ContactMethod::modified_mass, ContactMethod::barrier}) {
    Simulation sim(net, ball, initial_state(net, ball));
    IntegratorSpec integrator = with(Method::implicit_euler);
    integrator.step = 0.002;
    ContactSpec contact{method, 0.3};
    contact.gap = 1e-3;
    sim.configure({}, integrator, contact);
    EXPECT_EQ(allocations_of_a_step(sim, 80), 0) << static_cast<int>(method);
    EXPECT_GT(sim.state().touches.size(), 10u) << static_cast<int>(method);
  }
}

}  // namespace
}  // namespace retiarius

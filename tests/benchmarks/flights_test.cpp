// The plain explicit scheme against exact answers, and against the integrators in a flight.
#include "benchmarks/flights.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/plain_explicit.hpp"
#include "retiarius/motion/stable_step.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius::benchmarks {
namespace {

using retiarius::testing::straight_chain;

Material thread(bool compression, double damping) {
  Material m;
  m.axial_stiffness = 100.0;
  m.line_density = 0.1;
  m.compression = compression;
  m.damping = damping;
  return m;
}

// Two nodes and a spring: the elongation u follows u'' = -w^2 (u + tau u'), w^2 = 2 k / m.
double elongation_after(double h, double time, double tau) {
  Network net = straight_chain(1, 1.0, thread(true, tau));
  net.initial[1].x() += 0.001;
  PlainExplicit plain(net);
  const int steps = static_cast<int>(std::lround(time / h));
  for (int k = 0; k < steps; ++k) plain.step(h);
  return (plain.x[1] - plain.x[0]).norm() - 1.0;
}

TEST(PlainExplicit, OscillatesAsASpringDoes) {
  const Network net = straight_chain(1, 1.0, thread(true, 0.0));
  const double w = std::sqrt(2.0 * 100.0 / net.mass[0]), tau = 1e-3;
  const double decay = 0.5 * w * w * tau, own = std::sqrt(w * w - decay * decay);
  const double t = 2.0 * kPi / own;  // a period: u' = 0 at both ends
  EXPECT_NEAR(elongation_after(t / 20000, t, tau), 0.001 * std::exp(-decay * t), 2e-7);
}

TEST(PlainExplicit, IsStableUpToItsStepOnly) {
  for (const double tau : {0.0, 1e-3, 1e-2}) {
    const double h = PlainExplicit(straight_chain(1, 1.0, thread(true, tau))).stable_step();
    EXPECT_LT(std::abs(elongation_after(0.99 * h, 2000 * h, tau)), 0.02) << tau;
    // A hundred times the start's, or no number any more.
    EXPECT_FALSE(std::abs(elongation_after(1.01 * h, 2000 * h, tau)) < 0.1) << tau;
  }
}

TEST(PlainExplicit, SlackThreadsDoNotPush) {
  Network net = straight_chain(1, 1.0, thread(false, 1e-3));
  net.initial[1].x() -= 0.1;
  PlainExplicit plain(net);
  for (int k = 0; k < 100; ++k) plain.step(1e-4);
  EXPECT_EQ(plain.x, net.initial);
}

TEST(Flights, PlainAndOwnExplicitAgree) {
  Flight flight;
  flight.until = 0.1;
  flight.way = Way::explicitly;
  const FlightResult own = fly(flight);
  flight.way = Way::plain;
  const FlightResult plain = fly(flight);
  ASSERT_EQ(own.areas.size(), 2u);
  EXPECT_NEAR(own.areas[0], 1.25 * 1.25, 1e-12);
  EXPECT_GT(own.areas[1], 1.1 * own.areas[0]);
  EXPECT_LT(area_error(plain.areas, own.areas), 1e-3);
  EXPECT_GT(area_error(plain.areas, own.areas), 0.0);
  EXPECT_GT(own.substeps, 0.5 * plain.substeps);
}

TEST(Flights, AutoFliesAsTheMethodThatItTakes) {
  Flight flight;
  flight.until = 0.1;
  const FlightResult automatic = fly(flight);
  EXPECT_EQ(automatic.taken, "explicit");
  flight.way = Way::explicitly;
  EXPECT_EQ(fly(flight).areas, automatic.areas);
}

TEST(Flights, ImplicitEulerComesNear) {
  Flight flight;
  flight.until = 0.1;
  flight.way = Way::explicitly;
  const FlightResult own = fly(flight);
  flight.way = Way::euler;
  flight.step = 0.001;
  const FlightResult euler = fly(flight);
  EXPECT_EQ(euler.taken, "implicit-euler");
  EXPECT_EQ(euler.substeps, 0.0);
  EXPECT_GE(euler.iterations, 100.0);
  EXPECT_LT(area_error(euler.areas, own.areas), 0.01);
}

TEST(Flights, ErrorIsTheLargestRelativeOne) {
  EXPECT_NEAR(area_error({1.0, 2.2, 3.0}, {1.0, 2.0, 3.0, 9.0}), 0.1, 1e-12);
}

}  // namespace
}  // namespace retiarius::benchmarks

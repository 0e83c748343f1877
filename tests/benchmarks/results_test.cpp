// What is said of measurements.
#include "benchmarks/results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/error.hpp"

namespace retiarius::benchmarks {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Measurement step_of(Index nodes, double time, int threads = 1) {
  Measurement m;
  m.nodes = nodes;
  m.step = time;
  m.threads = threads;
  return m;
}

TEST(Results, GrowthAndEfficiencyAreThoseOfPowers) {
  EXPECT_NEAR(growth_exponent(step_of(10000, 0.02), step_of(40000, 0.16)), 1.5, 1e-12);
  EXPECT_NEAR(parallel_efficiency(step_of(100, 0.3), step_of(100, 0.2, 2)), 0.75, 1e-12);
}

TEST(Results, FlightsAreALineEach) {
  FlightResult r;
  r.flight.segments = 4;
  r.flight.way = Way::plain;
  r.taken = "plain explicit";
  r.seconds = 1.5;
  r.error = 0.002;
  const std::string csv = flights_csv({r, r});
  EXPECT_THAT(csv, StartsWith("# "));
  EXPECT_THAT(csv, HasSubstr("\nsegments,nodes,way,taken,step,until,seconds,substeps,iterations,"
                             "error\n4,0,plain-explicit,plain explicit,0.005,2,1.5000e+00,0,0,"
                             "2.000e-03\n4,"));
  EXPECT_THAT(flight_text(r), HasSubstr(" 0.200\n"));
}

TEST(Results, MissionsAreTimedToTheirEnd) {
  const std::string file = std::string(RETIARIUS_SOURCE_DIR) + "/missions/hexagon-gravity.toml";
  const MissionTime time =
      time_mission(file, {"phase[0].until=time >= 0.05", "integrator.solver=direct"});
  EXPECT_EQ(time.name, "hexagon-gravity");
  EXPECT_EQ(time.outcome, "finished");
  EXPECT_NEAR(time.simulated, 0.05, 1e-12);
  EXPECT_EQ(time.steps, 5);
  EXPECT_GT(time.iterations, 5);
  EXPECT_GT(time.seconds, 0.0);
  EXPECT_THAT(missions_csv({time}), HasSubstr("\nhexagon-gravity,phase[0].until=time >= 0.05 "
                                              "integrator.solver=direct,finished,"));
  EXPECT_THROW(time_mission(file, {"net.qqq=1"}), InputError);
}

}  // namespace
}  // namespace retiarius::benchmarks

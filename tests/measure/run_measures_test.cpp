#include "retiarius/measure/run_measures.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "retiarius/bodies/primitives.hpp"
#include "tiny_nets.hpp"

namespace retiarius {
namespace {

const Measure& find(const Measures& measures, const std::string& name) {
  for (const Measure& m : measures)
    if (m.name == name) return m;
  throw std::out_of_range(name);
}
double number(const Measures& m, const std::string& name) {
  return std::get<double>(find(m, name).value);
}
bool absent(const Measures& m, const std::string& name) {
  return std::holds_alternative<std::monostate>(find(m, name).value);
}
bool flag(const Measures& m, const std::string& name) {
  return std::get<bool>(find(m, name).value);
}

// Steps of h until `end`, every one of them measured.
void run(Simulation& sim, RunMeasures& measures, double end, double h = 0.01) {
  const double from = sim.state().time;
  const int steps = static_cast<int>(std::lround((end - from) / h));
  for (int k = 1; k <= steps; ++k) {
    const StepReport report = sim.advance(from + k * h, {});
    measures.step(sim, report);
  }
}

RunMeasures begun(const Network& net, const std::vector<Body>& bodies, const Simulation& sim) {
  RunMeasures measures(net, bodies, {2});
  measures.begin(sim);
  measures.begin_phase(sim, false);
  return measures;
}

// A square that flies through its own centre: every corner at 1 m/s along x and y, threads slack.
class CollapsingSquare : public ::testing::Test {
 protected:
  CollapsingSquare() : net_(make_square(100.0, 10.0)) {
    for (std::size_t i = 0; i < 4; ++i) net_.velocity[i] = -net_.design[i] + Vec3(0, 0, 3);
  }
  Network net_;
  std::vector<Body> none_;
};

TEST_F(CollapsingSquare, RowShowsTheMouth) {
  Simulation sim = start(net_, none_);
  RunMeasures measures = begun(net_, none_, sim);
  EXPECT_NEAR(measures.row(sim, 0).mouth_area, 4.0, 1e-14);
  run(sim, measures, 0.5);
  const HistoryRow row = measures.row(sim, 2);
  EXPECT_EQ(row.time, sim.state().time);
  EXPECT_EQ(row.step, 50);
  EXPECT_EQ(row.phase, 2);
  EXPECT_NEAR(row.mouth_area, 1.0, 1e-12);
  EXPECT_NEAR(row.mouth_vector_area, 1.0, 1e-12);
  EXPECT_NEAR(row.mouth_width, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(row.perimeter_area, 1.0, 1e-12);
  EXPECT_NEAR(row.kinetic_energy, 4.0 * 0.5 * 11.0, 1e-11);
  EXPECT_NEAR((row.momentum - Vec3(0, 0, 12)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(row.angular_momentum.norm(), 0.0, 1e-12);
  EXPECT_NEAR(row.peak_tension, 0.0, 1e-15);
  EXPECT_NEAR(row.peak_strain, 1.0 / 20.0 - 1.0, 1e-13);
  EXPECT_FALSE(row.smallest_distance.has_value());
  ASSERT_EQ(row.probes.size(), 1U);
  EXPECT_NEAR((row.probes[0].position - Vec3(-0.5, -0.5, 1.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(measures.mouth_ratio(), 0.25, 1e-13);
}

TEST_F(CollapsingSquare, WidestIsSeenWhenTheAreaHasFallenByOnePerCent) {
  Simulation sim = start(net_, none_);
  RunMeasures measures = begun(net_, none_, sim);
  EXPECT_FALSE(measures.widest());
  run(sim, measures, 0.005, 0.001);  // (1 - t)^2 = 0.990025
  EXPECT_FALSE(measures.widest());
  run(sim, measures, 0.006, 0.001);
  EXPECT_TRUE(measures.widest());
}

TEST_F(CollapsingSquare, MeasuresCountFromTheShot) {
  Simulation sim = start(net_, none_);
  RunMeasures measures = begun(net_, none_, sim);
  run(sim, measures, 0.5);
  EXPECT_TRUE(absent(measures.summary(), "mouth_area_max_travel"));
  measures.shot(sim, Vec3(0, 0, 2));
  EXPECT_FALSE(measures.widest());
  EXPECT_EQ(measures.travel(), 0.0);
  run(sim, measures, 1.8);
  const Measures m = measures.summary();
  EXPECT_NEAR(number(m, "mouth_area_flat"), 4.0, 1e-14);
  EXPECT_NEAR(number(m, "mouth_width_flat"), std::sqrt(8.0), 1e-14);
  EXPECT_NEAR(number(m, "mouth_area_max"), 4.0 * 0.64, 1e-11);
  EXPECT_NEAR(number(m, "mouth_area_max_time"), 1.8, 1e-12);
  EXPECT_NEAR(number(m, "mouth_area_max_travel"), 3.0 * 1.3, 1e-11);
  EXPECT_NEAR(number(m, "mouth_area_final"), 4.0 * 0.64, 1e-11);
  EXPECT_NEAR(measures.travel(), 3.0 * 1.3, 1e-11);
  EXPECT_EQ(std::get<std::int64_t>(find(m, "steps").value), 180);
  EXPECT_LT(number(m, "linear_momentum_drift"), 1e-12);
  EXPECT_EQ(std::get<std::int64_t>(find(measures.phase_summary(), "steps").value), 130);
}

TEST_F(CollapsingSquare, AreasAreProjectedAlongTheShot) {
  Simulation sim = start(net_, none_);
  RunMeasures measures = begun(net_, none_, sim);
  measures.shot(sim, Vec3(0, 1, 1));
  EXPECT_NEAR(measures.mouth_area(), 4.0 / std::sqrt(2.0), 1e-13);
  EXPECT_NEAR(measures.row(sim, 0).mouth_vector_area, 4.0, 1e-13);
  measures.shot(sim, Vec3(1, 0, 0));  // only the first shot counts
  EXPECT_NEAR(measures.mouth_area(), 4.0 / std::sqrt(2.0), 1e-13);
}

TEST(RunMeasures, PeaksOfAPulledThread) {
  const Network net = make_square(100.0, 0.8);  // strain 0.25, T = 25 N everywhere
  const std::vector<Body> none;
  Simulation sim = start(net, none);
  RunMeasures measures = begun(net, none, sim);
  EXPECT_NEAR(measures.row(sim, 0).peak_tension, 25.0, 1e-12);
  EXPECT_TRUE(absent(measures.summary(), "peak_tension"));
  EXPECT_NEAR(number(measures.summary(), "peak_strain"), 0.25, 1e-14);
  double largest = -1.0, mean = 0.0;
  for (int k = 1; k <= 10; ++k) {
    measures.step(sim, sim.advance(0.002 * k, {}));
    largest = std::max(largest, sim.tensions()[0]);
    mean += sim.tensions()[0] / 10.0;
  }
  EXPECT_LT(largest, 25.0);
  EXPECT_NEAR(number(measures.summary(), "peak_tension"), largest, 1e-9);
  EXPECT_NEAR(number(measures.summary(), "peak_tension_20ms"), mean, 1e-9);
  EXPECT_GT(measures.row(sim, 0).integrator_loss, 0.0);
}

TEST(RunMeasures, FirstContactAndSmallestDistance) {
  Network net = make_square(100.0, 10.0);
  for (Vec3& v : net.velocity) v = Vec3(0, 0, -1);
  const std::vector<Body> bodies = {
      make_body(make_plane(), ShapeKind::plane, Vec3(0, 0, -0.205 - kThreadRadius))};
  ContactSpec contact;
  contact.method = ContactMethod::modified_mass;
  Simulation sim = start(net, bodies, {}, contact);
  RunMeasures measures = begun(net, bodies, sim);
  EXPECT_NEAR(*measures.row(sim, 0).smallest_distance, 0.205, 1e-14);
  run(sim, measures, 0.2);
  EXPECT_FALSE(measures.touched());
  EXPECT_NEAR(*measures.row(sim, 0).smallest_distance, 0.005, 1e-12);
  run(sim, measures, 0.4);
  EXPECT_TRUE(measures.touched());
  EXPECT_NEAR(number(measures.summary(), "first_contact_time"), 0.21, 1e-12);
  EXPECT_NEAR(number(measures.summary(), "smallest_distance"), 0.0, 1e-12);
  EXPECT_TRUE(absent(measures.summary(), "captured_share"));
  EXPECT_TRUE(absent(measures.summary(), "success"));
  EXPECT_LT(number(measures.summary(), "linear_momentum_drift"), 1e-12);
  measures.shot(sim, Vec3(0, 0, 1));
  EXPECT_FALSE(measures.touched());
}

// Net and target push each other: nothing comes from outside, whatever each of them gains.
TEST(RunMeasures, DriftCountsTheBodiesThatTheNetHits) {
  Network net = make_square(100.0, 3.0);
  for (Index i = 0; i < 4; ++i) net.velocity[i] = Vec3(0, 0, i == 0 ? -3.0 : -2.0);
  std::vector<Body> bodies = {
      make_body(make_box(Vec3(3, 3, 1)), ShapeKind::box, Vec3(0.4, 0, -0.7))};
  bodies[0].fixed = false;
  bodies[0].mass = 500.0;
  bodies[0].inertia = 400.0 * Mat3::Identity();
  ContactSpec contact;
  contact.method = ContactMethod::modified_mass;
  Simulation sim = start(net, bodies, {}, contact);
  RunMeasures measures = begun(net, bodies, sim);
  run(sim, measures, 0.5);
  EXPECT_TRUE(measures.touched());
  EXPECT_GT(sim.state().bodies[0].velocity.norm(), 0.01);
  EXPECT_LT(number(measures.summary(), "linear_momentum_drift"), 1e-12);
}

// A shot off the mass centre, under gravity, of a net that spins and lies away from the origin: all
// impulses are explained.
TEST(RunMeasures, DriftsVanishWhereAllImpulsesAreKnown) {
  Network net = make_square();
  for (std::size_t i = 0; i < 4; ++i) {
    net.velocity[i] = Vec3(0, 0, 2).cross(net.design[i]);
    net.initial[i] += Vec3(30, -20, 10);
  }
  const std::vector<Body> none;
  Simulation sim = start(net, none);
  IntegratorSpec midpoint;
  midpoint.method = Method::midpoint;
  midpoint.tolerance = 1e-10;
  sim.configure({Vec3(1, 2, -9), 0.3}, midpoint, {});
  RunMeasures measures = begun(net, none, sim);
  sim.kick(1, Vec3(4, 5, 6));
  run(sim, measures, 1.0);
  EXPECT_LT(number(measures.summary(), "linear_momentum_drift"), 1e-12);
  EXPECT_LT(number(measures.summary(), "angular_momentum_drift"), 1e-9);
}

// The next state has gained 0.5 m/s at one of four nodes from nowhere.
TEST(RunMeasures, DriftSeesAnImpulseFromNowhere) {
  Network net = make_square(100.0, 10.0);
  for (Vec3& v : net.velocity) v = Vec3(0, 0, 1);
  const std::vector<Body> none;
  Simulation sim = start(net, none);
  RunMeasures measures = begun(net, none, sim);
  State wrong = initial_state(net, none);
  wrong.v[0].z() += 0.5;
  Simulation other(net, none, wrong);
  other.configure({}, {}, {});
  measures.step(other, other.advance(0.01, {}));
  EXPECT_NEAR(number(measures.summary(), "linear_momentum_drift"), 0.5 / 4.5, 1e-12);
  // About the mass centre at the start: the lever is (1, 1), vc = 1.125 m/s, and the scale is
  // sqrt(2) (0.375 + 3 x 0.125), but for the little that the node has moved ahead.
  EXPECT_NEAR(number(measures.summary(), "angular_momentum_drift"),
              0.5 * std::sqrt(2.0) / (std::sqrt(2.0) * 0.75), 1e-5);
}

TEST(RunMeasures, DriftsCountNoPrescribedMotion) {
  Network net = make_square(100.0, 10.0);
  for (Vec3& v : net.velocity) v = Vec3(0, 0, 1);
  const std::vector<Body> none;
  Simulation sim = start(net, none);
  RunMeasures measures(net, none, {});
  measures.begin(sim);
  measures.begin_phase(sim, true);
  run(sim, measures, 0.1);
  EXPECT_TRUE(absent(measures.summary(), "linear_momentum_drift"));
  measures.set_prescribed(sim, false);
  run(sim, measures, 0.2);
  EXPECT_LT(number(measures.summary(), "linear_momentum_drift"), 1e-12);
}

TEST(RunMeasures, DriftsAreAbsentAtRest) {
  const Network net = make_square(100.0, 2.0);
  const std::vector<Body> none;
  Simulation sim = start(net, none);
  RunMeasures measures = begun(net, none, sim);
  run(sim, measures, 0.05);
  EXPECT_TRUE(absent(measures.summary(), "linear_momentum_drift"));
  EXPECT_TRUE(absent(measures.summary(), "angular_momentum_drift"));
  EXPECT_TRUE(absent(measures.summary(), "smallest_distance"));
  EXPECT_TRUE(absent(measures.summary(), "success"));
}

TEST(RunMeasures, ChangeOfGravityIsNoIntegratorLoss) {
  const Network net = make_square(100.0, 10.0);
  const std::vector<Body> none;
  Simulation sim = start(net, none, {Vec3(0, 0, -10), 0.0});
  RunMeasures measures = begun(net, none, sim);
  run(sim, measures, 0.5);
  const double before = measures.row(sim, 0).integrator_loss;
  EXPECT_GT(before, 0.0);
  sim.configure({}, {}, {});
  EXPECT_NEAR(measures.row(sim, 0).integrator_loss, before, 1e-12);
  measures.begin_phase(sim, false);
  EXPECT_NEAR(measures.row(sim, 1).integrator_loss, before, 1e-12);
  EXPECT_EQ(measures.row(sim, 1).gravity_energy, 0.0);
  run(sim, measures, 0.6);
  EXPECT_NEAR(measures.row(sim, 1).integrator_loss, before, 1e-9);
}

// Eight nodes around the target, four that shut the mouth above it.
class ShutNet : public ::testing::Test {
 protected:
  ShutNet() {
    std::vector<Vec3> places;
    std::vector<std::pair<Index, Index>> pairs;
    for (Index k = 0; k < 8; ++k)
      places.emplace_back((k & 1) ? 1 : -1, (k & 2) ? 1 : -1, (k & 4) ? 1 : -1);
    for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
      places.emplace_back(0.05 * x, 0.05 * y, 1.2);
    for (Index k = 1; k < 12; ++k) pairs.emplace_back(k - 1, k);
    net_ = make_net(places, pairs, 100.0, 3.0);
    net_.corners = {8, 9, 10, 11};
    for (const Index c : net_.corners) net_.design[c] *= 20.0;
  }
  Measures after(double time, const Vec3& target) {
    bodies_ = {make_body(make_sphere(0.5), ShapeKind::sphere, target)};
    Simulation sim = start(net_, bodies_);
    RunMeasures measures = begun(net_, bodies_, sim);
    run(sim, measures, time, 0.05);
    return measures.summary();
  }
  Network net_;
  std::vector<Body> bodies_;
};

TEST_F(ShutNet, HasSucceededWithTheTargetInside) {
  const Measures m = after(0.5, Vec3::Zero());
  EXPECT_NEAR(number(m, "captured_share"), 1.0, 1e-12);
  EXPECT_TRUE(flag(m, "closed"));
  EXPECT_TRUE(flag(m, "success"));
}

TEST_F(ShutNet, HasNotSucceededTooEarlyOrWithTheTargetOutside) {
  EXPECT_FALSE(flag(after(0.45, Vec3::Zero()), "closed"));
  EXPECT_FALSE(flag(after(0.45, Vec3::Zero()), "success"));
  const Measures outside = after(0.5, Vec3(1.0, 0, 0));
  EXPECT_TRUE(flag(outside, "closed"));
  EXPECT_NEAR(number(outside, "captured_share"), 0.5, 0.01);
  EXPECT_FALSE(flag(outside, "success"));
}

// The hull is the cube of side 2 with a roof of 0.2 above a square of 0.1; the sphere's radius 0.5.
TEST_F(ShutNet, TellsTheCaptureQuality) {
  bodies_ = {make_body(make_sphere(0.5), ShapeKind::sphere, Vec3::Zero())};
  Simulation sim = start(net_, bodies_);
  RunMeasures measures = begun(net_, bodies_, sim);
  const double roof = 0.2 / 3 * (4 + 0.01 + std::sqrt(4 * 0.01));
  const double slope = 4 * 0.5 * (2 + 0.1) * std::hypot(0.95, 0.2);
  const double center = (4 * 1.2) / 12;  // of twelve equal masses
  const double expected =
      0.1 * (8 + roof - kPi / 6) / (kPi / 6) + 0.1 * (20 + 0.01 + slope - kPi) / kPi + 0.8 * center;
  const HistoryRow row = measures.row(sim, 0);
  ASSERT_TRUE(row.capture_quality);
  EXPECT_NEAR(*row.capture_quality, expected, 1e-12);
  EXPECT_NEAR(number(measures.summary(), "capture_quality_final"), expected, 1e-12);
  measures.keep(row);  // nothing touches: nothing to settle
  EXPECT_TRUE(absent(measures.summary(), "capture_quality_settled"));
  EXPECT_TRUE(absent(measures.summary(), "capture_quality_settling_time"));
}

TEST_F(ShutNet, NamesAllMeasures) {
  std::vector<std::string> names;
  for (const Measure& m : after(0.1, Vec3::Zero())) names.push_back(m.name);
  const std::vector<std::string> expected = {"mouth_area_flat",
                                             "mouth_width_flat",
                                             "mouth_area_max",
                                             "mouth_area_max_time",
                                             "mouth_area_max_travel",
                                             "mouth_area_final",
                                             "mouth_vector_area_final",
                                             "mouth_width_final",
                                             "peak_tension",
                                             "peak_tension_20ms",
                                             "peak_strain",
                                             "first_contact_time",
                                             "first_contact_thread",
                                             "first_contact_body",
                                             "first_contact_x",
                                             "first_contact_y",
                                             "first_contact_z",
                                             "smallest_distance",
                                             "captured_share",
                                             "capture_quality_final",
                                             "capture_quality_settled",
                                             "capture_quality_settling_time",
                                             "closed",
                                             "success",
                                             "linear_momentum_drift",
                                             "angular_momentum_drift",
                                             "steps",
                                             "newton_iterations",
                                             "substeps",
                                             "unconverged_steps"};
  EXPECT_EQ(names, expected);
}

}  // namespace
}  // namespace retiarius

// A cable net hangs at rest from its four corners.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "verification/framework/line.hpp"
#include "verification/mujoco/mujoco_twin.hpp"
#include "verification/mujoco/outcome.hpp"

namespace retiarius::verification {

namespace {

const Vec3 kGravity(0.0, 0.0, -9.81);
constexpr double kRelaxation = 8.0;   // 1/s, damping of the way to rest
constexpr double kRestSpeed = 1e-11;  // m/s
constexpr double kLongest = 60.0;     // s, simulated

Network cable_net() {
  NetSpec spec;
  spec.pattern = Pattern::square;
  spec.side = 1.0;
  spec.mesh = 0.25;
  spec.segments = 2;
  spec.thread.young_modulus = 2.0e6;
  spec.thread.density = 1100.0;
  spec.thread.radius = 2.0e-3;
  spec.knot_mass = 5.0e-3;
  return build_network(spec);
}

// Ours, by the static solver.
std::vector<Vec3> rest_of(const Network& net, double& time) {
  const Stopwatch watch;
  const std::vector<Body> none;
  Simulation simulation(net, none, initial_state(net, none));
  simulation.configure({kGravity, 0.0}, with(Method::static_solve, 0.01, 1e-12), {});
  simulation.solve_static(held(net, net.corners));
  time = watch.seconds();
  return simulation.state().x;
}

// Theirs, by damped motion until nothing moves.
std::vector<Vec3> twin_rest(const Network& net, double& time) {
  const Stopwatch watch;
  MujocoTwin twin(net, net.corners, {kGravity, 4e-4, kRelaxation, false});
  do {
    for (int k = 0; k < 100; ++k) twin.step();
    if (!(twin.time() < kLongest)) throw Error("MuJoCo's net does not come to rest");
  } while (!(twin.largest_speed() < kRestSpeed));
  time = watch.seconds();
  std::vector<Vec3> x;
  x.reserve(net.initial.size());
  for (Index i = 0; i < net.node_count(); ++i) x.push_back(twin.position(i));
  return x;
}

}  // namespace

void hanging_net(Recorded& recorded) {
  const Network net = cable_net();
  RecordedScene scene{"hanging net", 0.0, 0.0};
  const std::vector<Vec3> ours = rest_of(net, scene.our_time);
  const std::vector<Vec3> theirs = twin_rest(net, scene.their_time);
  double largest = 0.0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    largest = std::max(largest, (ours[i] - theirs[i]).norm());
  // Both are the same equilibrium of the same springs. What moves at 1e-11 m/s under a damping of
  // 8 1/s, with modes no slower than 1 rad/s, is within about 1e-10 m of it.
  constexpr double kBound = 1e-9;
  const double sag = ours[net.center].z(), their_sag = theirs[net.center].z();
  recorded.comparisons.push_back(
      {scene.name, "height of the centre", "m", sag, their_sag, std::abs(sag - their_sag), kBound});
  recorded.comparisons.push_back(
      {scene.name, "largest distance of a node from its twin", "m", NAN, NAN, largest, kBound});
  recorded.scenes.push_back(scene);
  recorded.about.push_back(fmt::format(
      "Hanging net: a square net (side 1 m; mesh 0.25 m; 2 segments a piece; EA {:.3g} N; knots of "
      "5 g) at rest under 9.81 m/s2 in its four held corners. Ours by the static solver; MuJoCo's "
      "by damped motion with steps of 0.4 ms until nothing moves faster than 1e-11 m/s. Both are "
      "the equilibrium of the same springs: the bound is what that speed leaves.",
      net.materials.front().axial_stiffness));
}

}  // namespace retiarius::verification

// A chain of springs swings from one end.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "verification/framework/line.hpp"
#include "verification/mujoco/mujoco_twin.hpp"
#include "verification/mujoco/outcome.hpp"

namespace retiarius::verification {

namespace {

const Vec3 kGravity(0.0, 0.0, -9.81);
constexpr int kSegments = 10;
constexpr double kEnd = 2.0;         // s
constexpr double kSample = 0.05;     // s
constexpr double kOurStep = 1e-4;    // s, and half of it
constexpr double kTheirStep = 1e-4;  // s, and half of it

Network chain() {
  const double angle = kPi / 6.0;  // from the vertical
  const Vec3 direction(std::sin(angle), 0.0, -std::cos(angle));
  return straight_line(kSegments, 1.0, plain_thread(20.0, 0.05), direction);
}

using Path = std::vector<Vec3>;  // of the free end, at the samples

Path our_path(const Network& net, double h) {
  const std::vector<Body> none;
  Simulation simulation(net, none, initial_state(net, none));
  simulation.configure({kGravity, 0.0}, with(Method::newmark, h, 1e-11), {});
  const int each = static_cast<int>(std::lround(kSample / h));
  Path path;
  advance(simulation, h, static_cast<int>(std::lround(kEnd / h)), held(net, {0}), [&](int k) {
    if (k % each == 0) path.push_back(simulation.state().x.back());
  });
  return path;
}

Path their_path(const Network& net, double h) {
  MujocoTwin twin(net, {0}, {kGravity, h, 0.0, true});
  const int each = static_cast<int>(std::lround(kSample / h));
  const int count = static_cast<int>(std::lround(kEnd / h));
  Path path;
  for (int k = 1; k <= count; ++k) {
    twin.step();
    if (k % each == 0) path.push_back(twin.position(net.node_count() - 1));
  }
  return path;
}

double apart(const Path& a, const Path& b) {
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, (a[k] - b[k]).norm());
  return largest;
}

}  // namespace

void swinging_chain(Recorded& recorded) {
  const Network net = chain();
  RecordedScene scene{"swinging chain", 0.0, 0.0};
  const Path coarse = our_path(net, kOurStep);
  const Stopwatch ours_watch;
  const Path fine = our_path(net, 0.5 * kOurStep);
  scene.our_time = ours_watch.seconds();
  const Path their_coarse = their_path(net, kTheirStep);
  const Stopwatch theirs_watch;
  const Path theirs = their_path(net, 0.5 * kTheirStep);
  scene.their_time = theirs_watch.seconds();
  Path limit;  // what steps of order two lead to
  for (std::size_t k = 0; k < fine.size(); ++k)
    limit.push_back(fine[k] + (fine[k] - coarse[k]) / 3.0);

  // Of order two, the finer run has a third of what halving the step changed still before it, and
  // the extrapolation what is left of order four; MuJoCo's own error is far below both.
  const double expected = apart(coarse, fine) / 3.0;
  const auto add = [&](const std::string& quantity, double ours, double theirs_value,
                       double difference, double bound) {
    recorded.comparisons.push_back(
        {scene.name, quantity, "m", ours, theirs_value, difference, bound});
  };
  add("x of the free end at 2 s", fine.back().x(), theirs.back().x(),
      std::abs(fine.back().x() - theirs.back().x()), 1.1 * expected);
  add("largest distance of the free ends up to 2 s", NAN, NAN, apart(fine, theirs), 1.1 * expected);
  add("the same extrapolated to a step of zero", NAN, NAN, apart(limit, theirs), 0.05 * expected);
  add("change of MuJoCo's path by halving its step", NAN, NAN, apart(their_coarse, theirs),
      0.01 * expected);
  recorded.scenes.push_back(scene);
  recorded.about.push_back(fmt::format(
      "Swinging chain: {} springs in a row (1 m; EA 20 N; 0.05 kg/m) let go 30 degrees from the "
      "vertical; the path of the free end every 0.05 s for 2 s. Ours by the trapezoid with h = {} "
      "s "
      "and half of it; MuJoCo's by Runge-Kutta of order 4 with {} s. The bounds come from the "
      "order: "
      "what is left is a third of what halving the step changed, and a twentieth of that once it "
      "is "
      "extrapolated. The times are of the finer runs.",
      kSegments, kOurStep, 0.5 * kTheirStep));
}

}  // namespace retiarius::verification

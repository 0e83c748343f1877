// What a mission will need, before it is built.
#include <cmath>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/located_net.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/mission/trigger.hpp"

namespace retiarius {

namespace {

// Measured on square and hexagon nets from 10^4 to 10^5 nodes, rounded up: state, matrix, factor
// and measures together; the factor of a plane net grows as N log N.
double bytes_per_node(double nodes) { return 2500.0 + 300.0 * std::log2(std::max(2.0, nodes)); }
// A node's and its segments' numbers in one frame, compressed.
constexpr double kFrameBytesPerNode = 90.0;

// The mission time at which the last phase ends for certain; 0 if there is none.
double certain_end(const Mission& mission) {
  double time = 0.0;
  for (const PhaseSpec& phase : mission.phases) {
    const auto end = Trigger::parse(phase.until, phase.place).latest_time(time);
    if (!end) return 0.0;
    time = std::max(time, *end);
  }
  return time;
}

// The memory that this process may use, bytes.
double available_memory() {
  double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  return bytes;
}

// Least time between frames, s.
double frame_spacing(const Mission& mission) {
  double spacing = mission.output.frame_interval;
  if (!mission.output.every_step) return spacing;
  for (const PhaseSpec& phase : mission.phases) spacing = std::min(spacing, phase.integrator.step);
  return spacing;
}

}  // namespace

Estimate estimate(const Mission& mission) {
  const NetworkCounts counts = count_network(located_net(mission));
  Estimate e;
  e.nodes = counts.nodes;
  e.segments = counts.segments;
  e.joints = counts.joints;
  e.knots = counts.knots;
  e.memory = counts.nodes * bytes_per_node(counts.nodes);
  const double end = certain_end(mission);
  if (end > 0.0) e.frames = std::floor(end / frame_spacing(mission) + 1e-9) + 1.0;
  e.frame_bytes = e.frames * counts.nodes * kFrameBytesPerNode;
  return e;
}

void check_memory(const Estimate& e) {
  const double available = available_memory();
  if (e.memory <= available) return;
  throw InputError(fmt::format(
      "the net has {:.4g} nodes and {:.4g} segments and needs about {:.3g} GB of memory, more than "
      "the {:.3g} GB that this process may use; enlarge net.mesh or lower net.segments",
      e.nodes, e.segments, e.memory / 1e9, available / 1e9));
}

}  // namespace retiarius

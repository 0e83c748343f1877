// From a mission to what it moves: network, bodies, first positions.
#include <fmt/format.h>

#include "retiarius/base/random.hpp"
#include "retiarius/mission/located_net.hpp"
#include "retiarius/mission/run.hpp"

namespace retiarius {

namespace {

// The stream of random numbers that disturbs the start; one per use of the mission's seed.
constexpr std::uint64_t kDisturbanceStream = 1;

// Each coordinate uniform within +- disturbance.
void disturb(Network& network, double disturbance, std::uint64_t seed) {
  if (disturbance <= 0.0) return;
  for (std::size_t i = 0; i < network.initial.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double u = random_uniform(seed, kDisturbanceStream, 3 * i + static_cast<unsigned>(k));
      network.initial[i][k] += disturbance * (2.0 * u - 1.0);
    }
  }
}

}  // namespace

MissionModel::MissionModel(const Mission& mission) : network(build_network(located_net(mission))) {
  disturb(network, mission.net.disturbance, mission.seed);
  validate(network);
  for (const BodySpec& spec : mission.targets) bodies.push_back(build_body(spec, mission.folder));
}

}  // namespace retiarius

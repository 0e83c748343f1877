#include "retiarius/measure/frame.hpp"

#include "retiarius/forces/bending.hpp"
#include "retiarius/forces/stretching.hpp"

namespace retiarius {

std::vector<double> strains(const Network& network, const std::vector<Vec3>& x) {
  std::vector<double> strain;
  strain.reserve(network.segments.size());
  for (const Segment& s : network.segments)
    strain.push_back(axial_strain(x[s.a], x[s.b], s.rest_length));
  return strain;
}

Frame make_frame(const Simulation& simulation, Index phase) {
  const State& state = simulation.state();
  return {phase,
          &state,
          simulation.tensions(),
          strains(simulation.network(), state.x),
          node_curvatures(simulation.network(), state.x),
          contact_marks(simulation)};
}

}  // namespace retiarius

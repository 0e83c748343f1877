#include "retiarius/mission/beginning.hpp"

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

void check_same_net(const State& state, const Network& network, const char* what) {
  if (state.x.size() == network.mass.size()) return;
  throw InputError(
      fmt::format("{}: the saved state has {} nodes, the mission's net {}; a state "
                  "fits only the net that it was saved from",
                  what, state.x.size(), network.mass.size()));
}

// A checkpoint's content may be nonsense although its bytes are whole.
void check_resumable(const State& state, const MissionModel& model) {
  check_same_net(state, model.network, "resume");
  const auto nodes = static_cast<Index>(state.x.size());
  const auto bodies = static_cast<Index>(model.bodies.size());
  bool good = state.v.size() == state.x.size() && state.support.size() == state.x.size() &&
              state.bodies.size() == model.bodies.size();
  for (const Touch& touch : state.touches)
    good = good && touch.node >= 0 && touch.node < nodes && touch.body >= 0 && touch.body < bodies;
  good = good && state.memory.couplings.size() % 2 == 0;
  for (const Index node : state.memory.couplings) good = good && node >= 0 && node < nodes;
  if (!good) throw InputError("resume: the saved state has other bodies than the mission");
}

}  // namespace

Vec3 mission_axis(const Mission& mission, const Network& network) {
  for (const PhaseSpec& phase : mission.phases)
    if (phase.kind == PhaseKind::shoot) return phase.axis.normalized();
  return network.normal;
}

std::vector<Index> probe_nodes(const Mission& mission, const Network& network) {
  std::vector<Index> nodes;
  for (const ProbeSpec& probe : mission.probes) {
    const std::vector<Index> found = select_nodes(network, probe.node);
    if (found.size() != 1)
      throw InputError(probe.place, fmt::format("probe \"{}\": node = \"{}\" selects {} nodes; a "
                                                "probe watches one",
                                                probe.name, probe.node, found.size()));
    nodes.push_back(found.front());
  }
  return nodes;
}

std::vector<Phase> make_phases(const Mission& mission, const MissionModel& model, bool fresh) {
  MissionFrame frame;
  frame.axis = mission_axis(mission, model.network);
  if (!model.bodies.empty()) frame.target = 0;
  frame.fresh = fresh;
  std::vector<Phase> phases;
  for (const PhaseSpec& spec : mission.phases) {
    Phase phase;
    phase.spec = &spec;
    phase.trigger = Trigger::parse(spec.until, spec.place);
    phase.actions = make_actions(spec, model.network, frame);
    phases.push_back(std::move(phase));
  }
  return phases;
}

double round_off_energy(const Network& network) {
  constexpr double kStrain = 1e-7;
  double sum = 0.0;
  for (const Segment& s : network.segments)
    sum += 0.5 * network.materials[s.material].axial_stiffness * s.rest_length * kStrain * kStrain;
  return sum;
}

State first_state(const Mission& mission, const MissionModel& model, const RunOptions& options) {
  if (options.resume) {
    check_resumable(options.resume->checkpoint.state, model);
    return options.resume->checkpoint.state;
  }
  State state = initial_state(model.network, model.bodies);
  if (!mission.net.state.empty()) {
    if (!options.net_state)
      throw InputError(
          fmt::format("net.state = \"{}\": this run was not given the state that it "
                      "names",
                      mission.net.state));
    check_same_net(*options.net_state, model.network, "net.state");
    state.x = options.net_state->x;
    state.v = options.net_state->v;
    for (Vec3& x : state.x) x += mission.net.position;
  }
  if (options.start) {
    check_same_net(*options.start, model.network, "start");
    state.x = options.start->x;
    state.v = options.start->v;
    if (options.start->bodies.size() == state.bodies.size()) {
      state.bodies = options.start->bodies;
      state.touches = options.start->touches;
    }
  }
  return state;
}

}  // namespace retiarius

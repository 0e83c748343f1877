// What a run begins with: its phases, the nodes it watches, its first state.
#pragma once

#include <memory>
#include <vector>

#include "retiarius/mission/phase_action.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/mission/trigger.hpp"

namespace retiarius {

struct Phase {
  const PhaseSpec* spec = nullptr;
  Trigger trigger;
  std::vector<std::unique_ptr<PhaseAction>> actions;
};

// The first shot's axis, turned to a unit vector; without a shot the flat net's normal.
Vec3 mission_axis(const Mission& mission, const Network& network);

// Of the mission's probes in their order. Throws InputError where one selects not just one node.
std::vector<Index> probe_nodes(const Mission& mission, const Network& network);

// fresh: the net starts as designed, not from a saved state. Throws InputError.
std::vector<Phase> make_phases(const Mission& mission, const MissionModel& model, bool fresh);

// Energy that the rounding of strains alone can make, J: a strain of 1e-7 in all threads, far above
// that of coordinates kilometres from the origin and far below any motion.
double round_off_energy(const Network& network);

// That the options give, or the mission's. Throws InputError where it does not fit.
State first_state(const Mission& mission, const MissionModel& model, const RunOptions& options);

}  // namespace retiarius

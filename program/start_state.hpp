// Saved states that a run starts from.
#pragma once

#include <optional>

#include "retiarius/mission/mission.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius::program {

// The state that the mission's net.state names; none where it names none. Throws InputError.
std::optional<State> net_state(const Mission& mission);

}  // namespace retiarius::program

// What `auto` stands for in the phases of a mission.
#pragma once

#include <string>
#include <vector>

#include "retiarius/mission/mission.hpp"
#include "retiarius/motion/choice.hpp"

namespace retiarius {

class Simulation;
struct MissionModel;

struct PhaseChoice {
  std::string phase;
  Choice choice;
};
std::vector<PhaseChoice> choices_of(const Mission& mission, const Simulation& simulation);
std::vector<PhaseChoice> choices_of(const Mission& mission, const MissionModel& model);

// A line for each thing that was chosen, with the phases that it holds for and the reason; nothing
// where the mission names all methods itself.
std::string choices_text(const std::vector<PhaseChoice>& choices);

}  // namespace retiarius

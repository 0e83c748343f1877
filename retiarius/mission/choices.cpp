#include "retiarius/mission/choices.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "retiarius/mission/run.hpp"
#include "retiarius/motion/integrator.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius {

namespace {

// Lines in order of first use; the phases that share one are listed in it.
struct Line {
  std::string phases, what;
};

void add(std::vector<Line>& lines, const std::string& phase, const std::string& what) {
  const auto found =
      std::find_if(lines.begin(), lines.end(), [&](const Line& line) { return line.what == what; });
  if (found == lines.end()) {
    lines.push_back({phase, what});
  } else {
    found->phases += ", " + phase;
  }
}

}  // namespace

std::vector<PhaseChoice> choices_of(const Mission& mission, const Simulation& simulation) {
  std::vector<PhaseChoice> choices;
  for (const PhaseSpec& phase : mission.phases)
    choices.push_back({phase.name, simulation.choose(phase.integrator, phase.contact)});
  return choices;
}

std::vector<PhaseChoice> choices_of(const Mission& mission, const MissionModel& model) {
  return choices_of(
      mission, Simulation(model.network, model.bodies, initial_state(model.network, model.bodies)));
}

std::string choices_text(const std::vector<PhaseChoice>& choices) {
  std::vector<Line> lines;
  for (const auto& [phase, choice] : choices) {
    if (!choice.method_reason.empty())
      add(lines, phase,
          fmt::format("integrator {}: {}", to_string(choice.method), choice.method_reason));
    if (!choice.solver_reason.empty())
      add(lines, phase,
          fmt::format("solver {}: {}", to_string(choice.solver), choice.solver_reason));
  }
  std::string text;
  for (const Line& line : lines) text += fmt::format("{}: {}\n", line.phases, line.what);
  return text;
}

}  // namespace retiarius

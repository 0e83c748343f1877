#include <algorithm>

#include <fmt/format.h>

#include "retiarius/mission/reader.hpp"
#include "retiarius/mission/trigger.hpp"

namespace retiarius {

namespace {

void warn_about_thread(const NetSpec& net, std::vector<std::string>& out) {
  const ThreadSpec& thread = net.thread;
  if (thread.radius > 0.1) {
    out.push_back(fmt::format("net.thread.radius = {} m is a rope thicker than 20 cm; millimetres?",
                              thread.radius));
  }
  if (thread.young_modulus < 1e3) {
    out.push_back(fmt::format("net.thread.young_modulus = {} Pa is softer than any thread; GPa?",
                              thread.young_modulus));
  }
  if (thread.density < 10.0) {
    out.push_back(fmt::format("net.thread.density = {} kg/m3 is lighter than any fibre; g/cm3?",
                              thread.density));
  }
  if (net.pattern != Pattern::file && thread.radius > net.mesh / (4.0 * net.segments)) {
    out.push_back(fmt::format("net.thread.radius = {} m is large for segments of {} m",
                              thread.radius, net.mesh / net.segments));
  }
  if (thread.bending == Bending::none && thread.bending_stiffness) {
    out.push_back("net.thread.bending_stiffness has no effect with bending = \"none\"");
  }
}

void warn_about_phases(const Mission& mission, std::vector<std::string>& out) {
  for (const PhaseSpec& phase : mission.phases) {
    if (mission.targets.empty() && Trigger::parse(phase.until).uses("contact")) {
      out.push_back(
          fmt::format("phase {} waits for contact, but there is no [target]", phase.name));
    }
    if (phase.kind == PhaseKind::shoot && mission.net.corner_mass.mass == 0.0) {
      out.push_back(fmt::format("phase {} shoots, but net.corner_mass.mass is 0", phase.name));
    }
  }
  const bool touched = std::any_of(
      mission.phases.begin(), mission.phases.end(),
      [](const PhaseSpec& phase) { return phase.contact.method != ContactMethod::none; });
  if (!mission.targets.empty() && !touched) {
    out.push_back("there is a [target], but contact.method is \"none\": the net goes through it");
  }
}

}  // namespace

std::vector<std::string> mission_warnings(const Mission& mission) {
  std::vector<std::string> out;
  warn_about_thread(mission.net, out);
  warn_about_phases(mission, out);
  return out;
}

}  // namespace retiarius

// retiarius info MISSION: what a mission amounts to, before any computing.
#include <cmath>
#include <memory>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "program/arguments.hpp"
#include "program/commands.hpp"
#include "program/console.hpp"
#include "program/text_table.hpp"
#include "retiarius/mission/choices.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius::program {

namespace {

std::string net_section(const Mission& mission, const Network& network) {
  const double total = std::accumulate(network.mass.begin(), network.mass.end(), 0.0);
  const double corners = mission.net.corner_mass.mass * static_cast<double>(network.bullets.size());
  TextTable table;
  table.add("nodes", fmt::format("{}", network.node_count()));
  table.add("knots", fmt::format("{}", network.knots.size()));
  table.add("segments", fmt::format("{}", network.segment_count()));
  table.add("joints", fmt::format("{}", network.joints.size()));
  table.add("threads", fmt::format("{}", network.threads.size()));
  table.add("corners", fmt::format("{}", network.corners.size()));
  table.add("median rest length", quantity(median_rest_length(network), "m"));
  table.add("mass of the net", quantity(total - corners, "kg"));
  table.add("mass at corners", quantity(corners, "kg"));
  table.add("total mass", quantity(total, "kg"));
  return "net\n" + table.text();
}

// Material 0 is the thread's; a border of its own follows.
std::string thread_section(const Network& network) {
  TextTable table;
  table.add({"", "EA", "EI", "radius", "line density", "axial wave speed"});
  for (std::size_t k = 0; k < network.materials.size(); ++k) {
    const Material& m = network.materials[k];
    table.add({k == 0 ? "thread" : "border", quantity(m.axial_stiffness, "N"),
               m.bending == Bending::none ? "none" : quantity(m.bending_stiffness, "N m2"),
               quantity(m.radius, "m"), quantity(m.line_density, "kg/m"),
               quantity(std::sqrt(m.axial_stiffness / m.line_density), "m/s")});
  }
  return "\nthread\n" + table.text();
}

std::string step_section(const Mission& mission, const Network& network) {
  const StableStep stable = stable_explicit_step(network);
  TextTable table;
  if (stable.segment != kNone) {
    const Segment& segment = network.segments[static_cast<std::size_t>(stable.segment)];
    table.add(
        "stable explicit step",
        fmt::format("{}, set by segment {} (nodes {} and {}, {} long)", quantity(stable.step, "s"),
                    stable.segment, segment.a, segment.b, quantity(segment.rest_length, "m")));
  }
  table.add("the mission's step", quantity(mission.integrator.step, "s"));
  if (mission.integrator.method == Method::explicit_differences) {
    table.add("explicit sub-steps in it",
              fmt::format("{}", explicit_substeps(stable.step, mission.integrator,
                                                  mission.integrator.step)));
  }
  return "\nstep\n" + table.text();
}

// Indented like the tables.
std::string choice_section(const Mission& mission, const MissionModel& model) {
  const std::string text = choices_text(choices_of(mission, model));
  if (text.empty()) return "";
  std::string section = "\nchosen\n  ";
  for (std::size_t k = 0; k + 1 < text.size(); ++k) {
    section += text[k];
    if (text[k] == '\n') section += "  ";
  }
  return section + "\n";
}

std::string mass_text(const Body& body) { return body.fixed ? "fixed" : quantity(body.mass, "kg"); }

// Principal moments, the smallest first.
std::string inertia_text(const Body& body) {
  if (body.fixed) return "";
  const Vec3 principal = Eigen::SelfAdjointEigenSolver<Mat3>(body.inertia).eigenvalues();
  return fmt::format("{:.4g}, {:.4g}, {:.4g} kg m2", principal.x(), principal.y(), principal.z());
}

std::string body_section(const std::vector<Body>& bodies) {
  if (bodies.empty()) return "";
  TextTable table;
  table.add({"", "mass", "principal moments of inertia"});
  for (const Body& body : bodies) table.add({body.name, mass_text(body), inertia_text(body)});
  return "\nbodies\n" + table.text();
}

std::string need_section(const Estimate& need) {
  TextTable table;
  table.add("memory", "about " + byte_count(need.memory));
  if (need.frames > 0.0) {
    table.add("frames", fmt::format("at most {:.0f}", need.frames));
    table.add("frames on disk", "about " + byte_count(need.frame_bytes));
  } else {
    table.add("frames", "unknown: no time by which the last phase ends");
  }
  return "\nneeds\n" + table.text();
}

}  // namespace

void add_info_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("info", "Print sizes, masses, stable step and memory of a mission");
  auto mission_arguments = std::make_shared<MissionArguments>();
  mission_arguments->add_to(*command);
  command->callback([mission_arguments] {
    const Mission mission = mission_arguments->read();
    const Estimate need = estimate(mission);
    check_memory(need);
    const MissionModel model(mission);
    if (!mission.title.empty()) print(mission.title + "\n\n");
    print(net_section(mission, model.network) + thread_section(model.network) +
          step_section(mission, model.network) + choice_section(mission, model) +
          body_section(model.bodies) + need_section(need));
  });
}

}  // namespace retiarius::program

#include "retiarius/study/levels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/mission/run.hpp"
#include "retiarius/mission/trigger.hpp"

namespace retiarius {

namespace {

bool is_static(const PhaseSpec& phase) { return phase.integrator.method == Method::static_solve; }

Mission refined(Mission mission, int step_halvings, int mesh_doublings) {
  const double share = std::ldexp(1.0, -step_halvings);
  mission.integrator.step *= share;
  for (PhaseSpec& phase : mission.phases) phase.integrator.step *= share;
  mission.net.segments <<= mesh_doublings;
  mission.net.corner_mass.bridle_segments <<= mesh_doublings;
  return mission;
}

// Steps until the known end; phases have steps of their own.
double steps_of(const Mission& mission) {
  double time = 0.0, steps = 0.0;
  for (const PhaseSpec& phase : mission.phases) {
    if (is_static(phase)) continue;
    const auto end = Trigger::parse(phase.until, phase.place).latest_time(time);
    if (!end) return 0.0;
    steps += std::ceil(std::max(0.0, *end - time) / phase.integrator.step - 1e-6);
    time = std::max(time, *end);
  }
  return steps;
}

// All names of nodes that the mission gives.
std::vector<std::string> node_names(const Mission& mission) {
  std::vector<std::string> names;
  const auto add = [&](const std::vector<std::string>& more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  for (const PhaseSpec& phase : mission.phases) {
    add(phase.fix);
    add(phase.grips);
    for (const MoveSpec& move : phase.move) add(move.nodes);
  }
  for (const ProbeSpec& probe : mission.probes) names.push_back(probe.node);
  return names;
}

// A name that selects another place of the net once the mesh is finer; empty: there is none.
std::string moved_name(const Mission& coarse, const Mission& fine) {
  const Network a = build_network(coarse.net), b = build_network(fine.net);
  for (const std::string& name : node_names(coarse)) {
    if (name.empty() || name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::vector<Index> in_a = select_nodes(a, name), in_b = select_nodes(b, name);
    if ((a.design[in_a.front()] - b.design[in_b.front()]).norm() > 1e-9 * coarse.net.side)
      return name;
  }
  return {};
}

// Why the mesh cannot be varied; empty: it can.
std::string mesh_obstacle(const Mission& mission) {
  if (mission.net.pattern == Pattern::file)
    return "the net is read from a file, so its mesh cannot be refined";
  if (!mission.net.state.empty())
    return "net.state gives the places of the nodes, so the mesh cannot be refined";
  const std::string name = moved_name(mission, refined(mission, 0, 1));
  if (!name.empty())
    return fmt::format(
        "node {} lies inside a piece and would be another one in a finer mesh; name a knot or a "
        "corner instead",
        name);
  return {};
}

std::string step_obstacle(const Mission& mission) {
  if (std::all_of(mission.phases.begin(), mission.phases.end(), is_static))
    return "every phase is solved statically, so there is no step to halve";
  return {};
}

Level make_level(const Mission& mission, int step_halvings, int mesh_doublings) {
  Level level;
  level.mission = refined(mission, step_halvings, mesh_doublings);
  level.step_halvings = step_halvings;
  level.mesh_doublings = mesh_doublings;
  level.nodes = estimate(level.mission).nodes;
  level.steps = steps_of(level.mission);
  level.cost = std::ldexp(level.nodes / estimate(mission).nodes, step_halvings);
  if (step_halvings > 0)
    level.name = fmt::format("h = {:.6g} s", level.mission.phases.front().integrator.step);
  else if (mesh_doublings > 0)
    level.name = fmt::format("{} segments a piece", level.mission.net.segments);
  else
    level.name = "as given";
  return level;
}

double size_of(const Level& level, Vary vary) {
  if (vary == Vary::mesh) return level.mission.net.mesh / level.mission.net.segments;
  for (const PhaseSpec& phase : level.mission.phases)
    if (!is_static(phase)) return phase.integrator.step;
  return level.mission.integrator.step;
}

}  // namespace

double Plan::cost() const {
  double sum = 0.0;
  for (const Level& level : levels) sum += level.cost;
  return sum;
}

Plan plan_levels(const Mission& mission, int count, Vary vary) {
  if (count < 2 || count > 10)
    throw InputError(fmt::format("a convergence study has 2 to 10 levels, not {}", count));
  Plan plan;
  plan.levels.push_back(make_level(mission, 0, 0));
  for (Vary one : {Vary::step, Vary::mesh}) {
    if (vary != Vary::both && vary != one) continue;
    const std::string obstacle =
        one == Vary::step ? step_obstacle(mission) : mesh_obstacle(mission);
    if (!obstacle.empty()) {
      if (vary != Vary::both) throw InputError(obstacle);
      plan.notes.push_back(obstacle);
      continue;
    }
    Series series{one, one == Vary::step ? "time step" : "mesh", {0}, {}};
    for (int k = 1; k < count; ++k) {
      series.levels.push_back(plan.levels.size());
      plan.levels.push_back(
          make_level(mission, one == Vary::step ? k : 0, one == Vary::mesh ? k : 0));
    }
    for (std::size_t level : series.levels)
      series.sizes.push_back(size_of(plan.levels[level], one));
    plan.series.push_back(std::move(series));
  }
  if (plan.series.empty())
    throw InputError(fmt::format("there is nothing to vary: {}", fmt::join(plan.notes, "; ")));
  if (mission.net.disturbance > 0.0)
    plan.notes.push_back("net.disturbance draws anew for each mesh, so its levels start apart");
  return plan;
}

}  // namespace retiarius

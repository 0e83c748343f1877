#include "retiarius/mission/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/measure/frame.hpp"
#include "retiarius/measure/run_measures.hpp"
#include "retiarius/mission/phase_action.hpp"
#include "retiarius/mission/step_grid.hpp"
#include "retiarius/mission/trigger.hpp"

namespace retiarius {

namespace {

using Clock = std::chrono::steady_clock;

// Seconds of wall time between checkpoints within a phase.
constexpr double kCheckpointInterval = 30.0;

struct Phase {
  const PhaseSpec* spec = nullptr;
  Trigger trigger;
  std::vector<std::unique_ptr<PhaseAction>> actions;
};

// The first shot's axis, turned to a unit vector; without a shot the flat net's normal.
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

void check_same_net(const State& state, const Network& network, const char* what) {
  if (state.x.size() == network.mass.size()) return;
  throw InputError(
      fmt::format("{}: the saved state has {} nodes, the mission's net {}; a state "
                  "fits only the net that it was saved from",
                  what, state.x.size(), network.mass.size()));
}

// Energy that the rounding of strains alone can make, J: a strain of 1e-7 in all threads, far above
// that of coordinates kilometres from the origin and far below any motion.
double round_off_energy(const Network& network) {
  constexpr double kStrain = 1e-7;
  double sum = 0.0;
  for (const Segment& s : network.segments)
    sum += 0.5 * network.materials[s.material].axial_stiffness * s.rest_length * kStrain * kStrain;
  return sum;
}

State first_state(const Mission& mission, const MissionModel& model, const RunOptions& options) {
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

class MissionLoop {
 public:
  MissionLoop(const Mission& mission, const MissionModel& model, Observer& observer,
              const RunOptions& options)
      : mission_(mission),
        observer_(observer),
        options_(options),
        network_(model.network),
        phases_(make_phases(mission, model, mission.net.state.empty() && !options.start)),
        simulation_(model.network, model.bodies, first_state(mission, model, options),
                    options.wrap_law),
        measures_(model.network, model.bodies, probe_nodes(mission, model.network)),
        axis_(mission_axis(mission, model.network)),
        rows_(mission.output.interval),
        frames_(mission.output.frame_interval) {
    info_.mission = &mission;
    info_.network = &model.network;
    info_.bodies = &model.bodies;
  }

  RunReport run();

 private:
  void enter(Phase& phase, bool first);
  bool run_phase(Phase& phase);
  void advance(Phase& phase);
  void after_step(Phase& phase, const StepReport& step);
  std::vector<Prescribed> prescribe(const Phase& phase, double time) const;
  bool moves(const Phase& phase) const;
  TriggerValues trigger_values() const;
  void write(bool last);
  void leave(Phase& phase, const std::string& trigger);
  void check_strength();
  void check_energy(const HistoryRow& row);
  void fail(const std::string& reason);

  const Mission& mission_;
  Observer& observer_;
  const RunOptions& options_;
  const Network& network_;
  std::vector<Phase> phases_;
  Simulation simulation_;
  RunMeasures measures_;
  Vec3 axis_;
  OutputGrid rows_, frames_;
  RunModel info_;
  RunReport report_;
  Index phase_index_ = 0;
  double phase_start_ = 0.0;
  double fraction_ = 0.0;
  std::string broken_;
  bool told_unsettled_ = false;
  Index row_phase_ = 0;
  double energy_scale_ = round_off_energy(network_);  // J
  double first_gravity_energy_ = kInfinity;           // of the phase, J
  Clock::time_point started_ = Clock::now();
  Clock::time_point saved_ = Clock::now();
};

RunReport MissionLoop::run() {
  observer_.begin(info_);
  try {
    bool first = true;
    for (Phase& phase : phases_) {
      phase_index_ = static_cast<Index>(&phase - phases_.data());
      phase_start_ = simulation_.state().time;
      enter(phase, first);
      first = false;
      if (!run_phase(phase)) {
        report_.outcome = Outcome::interrupted;
        report_.reason = fmt::format("stopped from outside at {:.6g} s", simulation_.state().time);
        break;
      }
    }
    if (report_.outcome == Outcome::finished && !broken_.empty()) {
      report_.outcome = Outcome::broke;
      report_.reason = broken_;
    }
  } catch (const Error& e) {
    fail(e.what());
  } catch (const std::bad_alloc&) {
    fail("there is not enough memory to go on");
  }
  try {
    if (phase_index_ == static_cast<Index>(report_.phases.size()))
      leave(phases_[phase_index_], "failed");
    write(true);
    observer_.checkpoint(simulation_.state());
  } catch (const Error& e) {
    fail(e.what());
  }
  report_.measures = measures_.summary();
  const std::chrono::duration<double> wall = Clock::now() - started_;
  report_.measures.push_back({"wall_time", "s", wall.count()});
  observer_.end(report_);
  return report_;
}

// The first failure is the run's reason; what it brings about later is not.
void MissionLoop::fail(const std::string& reason) {
  if (report_.outcome == Outcome::failed) return;
  report_.outcome = Outcome::failed;
  report_.reason = reason;
}

void MissionLoop::enter(Phase& phase, bool first) {
  const PhaseSpec& spec = *phase.spec;
  simulation_.configure(spec.environment, spec.integrator, spec.contact);
  simulation_.hold_bodies(spec.kind == PhaseKind::fold);
  for (const auto& action : phase.actions) action->begin(simulation_);
  const bool still = spec.integrator.method == Method::static_solve;
  StepReport solved;
  if (still) solved = simulation_.solve_static(prescribe(phase, phase_start_));
  // Accounts begin once the first shape is found, which takes no physical time.
  if (first) measures_.begin(simulation_);
  if (spec.kind == PhaseKind::shoot) measures_.shot(simulation_, axis_);
  measures_.begin_phase(simulation_, moves(phase));
  if (still) measures_.step(simulation_, solved);
  log_to(options_.log, LogLevel::info,
         fmt::format("phase {} \"{}\" begins at {:.6g} s", phase_index_, spec.name, phase_start_));
  if (first) write(false);
}

// False where the run was stopped from outside.
bool MissionLoop::run_phase(Phase& phase) {
  const bool still = phase.spec->integrator.method == Method::static_solve;
  while (!still && !phase.trigger.evaluate(trigger_values())) {
    if (options_.stop && *options_.stop) {
      leave(phase, "interrupted");
      return false;
    }
    advance(phase);
  }
  leave(phase, still ? "static solution" : phase.trigger.text());
  return true;
}

std::vector<Prescribed> MissionLoop::prescribe(const Phase& phase, double time) const {
  std::vector<Prescribed> all;
  for (const auto& action : phase.actions) action->prescribe(simulation_, time, all);
  // Where two actions claim a node, the later one (the phase's kind) has it.
  std::stable_sort(all.begin(), all.end(),
                   [](const Prescribed& a, const Prescribed& b) { return a.node < b.node; });
  std::vector<Prescribed> result;
  for (const Prescribed& p : all) {
    if (!result.empty() && result.back().node == p.node) {
      result.back() = p;
    } else {
      result.push_back(p);
    }
  }
  return result;
}

bool MissionLoop::moves(const Phase& phase) const {
  return std::any_of(phase.actions.begin(), phase.actions.end(),
                     [](const auto& action) { return action->moves(); });
}

void MissionLoop::advance(Phase& phase) {
  const double now = simulation_.state().time;
  const bool adaptive = phase.spec->integrator.adaptive;
  double end = next_on_grid(now, adaptive ? mission_.output.interval : phase.spec->integrator.step);
  if (const auto latest = phase.trigger.latest_time(phase_start_);
      adaptive && latest && *latest > now + kSameTime)
    end = std::min(end, *latest);
  for (const auto& action : phase.actions) {
    const auto event = action->next_event(now);
    if (event && *event > now + kSameTime && *event < end - kSameTime) end = *event;
  }
  do {
    const StepReport step =
        simulation_.advance(end, [&](double time) { return prescribe(phase, time); });
    after_step(phase, step);
  } while (!adaptive && simulation_.state().time < end);
  bool acted = false;
  for (const auto& action : phase.actions) {
    const auto event = action->next_event(now);
    if (!event || *event > simulation_.state().time + kSameTime) continue;
    action->act(simulation_);
    acted = true;
  }
  if (acted) measures_.set_prescribed(simulation_, moves(phase));
  write(false);
}

void MissionLoop::after_step(Phase& phase, const StepReport& step) {
  measures_.step(simulation_, step);
  if (mission_.output.every_step && frames_.due(simulation_.state().time, true))
    observer_.frame(make_frame(simulation_, phase_index_));
  check_strength();
  if (step.unsettled > 0 && !told_unsettled_) {
    told_unsettled_ = true;
    log_to(options_.log, LogLevel::warning,
           fmt::format("contacts did not settle in {} of {} sub-steps before {:.6g} s; a smaller "
                       "integrator.substep or an implicit method may be needed",
                       step.unsettled, step.substeps, simulation_.state().time));
  }
  const double now = simulation_.state().time;
  if (const auto end = phase.trigger.latest_time(phase_start_); end && *end > phase_start_)
    fraction_ = (now - phase_start_) / (*end - phase_start_);
  else
    fraction_ = 0.0;
  observer_.progress(simulation_.state(), phase_index_, fraction_);
  if (std::chrono::duration<double>(Clock::now() - saved_).count() > kCheckpointInterval) {
    observer_.checkpoint(simulation_.state());
    saved_ = Clock::now();
  }
}

TriggerValues MissionLoop::trigger_values() const {
  TriggerValues v;
  v.time = simulation_.state().time;
  v.phase_time = v.time - phase_start_;
  v.mouth_area = measures_.mouth_area();
  v.mouth_ratio = measures_.mouth_ratio();
  v.distance = measures_.travel();
  v.contact = measures_.touched();
  v.widest = measures_.widest();
  return v;
}

// Rows and frames at their times; the last state always.
void MissionLoop::write(bool last) {
  const double now = simulation_.state().time;
  if (rows_.due(now, last)) {
    const HistoryRow row = measures_.row(simulation_, phase_index_);
    measures_.keep(row);
    observer_.history(row);
    if (!last) check_energy(row);
  }
  if (frames_.due(now, last)) observer_.frame(make_frame(simulation_, phase_index_));
}

void MissionLoop::leave(Phase& phase, const std::string& trigger) {
  PhaseReport r;
  r.name = phase.spec->name;
  r.kind = phase.spec->kind;
  r.start = phase_start_;
  r.end = simulation_.state().time;
  r.trigger = trigger;
  r.measures = measures_.phase_summary();
  for (const auto& action : phase.actions) {
    const Measures own = action->measures(simulation_);
    r.measures.insert(r.measures.end(), own.begin(), own.end());
  }
  report_.phases.push_back(std::move(r));
  observer_.checkpoint(simulation_.state());
  saved_ = Clock::now();
}

// An integrator that is unstable at its step makes energy from nothing while every step converges;
// such a run is wrong and ends. The scale is the largest energy that any cause has moved so far.
void MissionLoop::check_energy(const HistoryRow& row) {
  constexpr double kGrowth = 10.0;
  if (!std::isfinite(first_gravity_energy_)) first_gravity_energy_ = row.gravity_energy;
  if (row.phase != row_phase_) {  // the gravity of another phase is another field
    first_gravity_energy_ = row.gravity_energy;
    row_phase_ = row.phase;
  }
  if (row.integrator_loss >= 0.0)
    energy_scale_ =
        std::max(energy_scale_, row.kinetic_energy + row.stretching_energy + row.bending_energy);
  energy_scale_ = std::max({energy_scale_, std::abs(row.prescribed_work),
                            std::abs(row.gravity_energy - first_gravity_energy_)});
  if (-row.integrator_loss <= kGrowth * energy_scale_) return;
  throw RunError(fmt::format(
      "the integrator has made {:.3g} J from nothing by {:.6g} s, where {:.3g} J were moved: it is "
      "unstable at this step. Take a smaller integrator.step or integrator.method = "
      "\"implicit-euler\"",
      -row.integrator_loss, row.time, energy_scale_));
}

// The first segment whose tension exceeds its thread's strength is remembered; the run goes on.
void MissionLoop::check_strength() {
  if (!broken_.empty()) return;
  const std::vector<double>& tension = simulation_.tensions();
  for (std::size_t k = 0; k < tension.size(); ++k) {
    const double strength = network_.materials[network_.segments[k].material].strength;
    if (tension[k] <= strength) continue;
    broken_ =
        fmt::format("segment {} carried {:.4g} N at {:.6g} s, more than its strength {:.4g} N", k,
                    tension[k], simulation_.state().time, strength);
    log_to(options_.log, LogLevel::warning, broken_);
    return;
  }
}

}  // namespace

void check_run(const Mission& mission, const MissionModel& model, const RunOptions& options) {
  Observer nobody;
  MissionLoop(mission, model, nobody, options);
}

RunReport run_mission(const Mission& mission, const MissionModel& model, Observer& observer,
                      const RunOptions& options) {
  MissionLoop loop(mission, model, observer, options);
  return loop.run();
}

}  // namespace retiarius

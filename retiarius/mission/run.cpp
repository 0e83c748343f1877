#include "retiarius/mission/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/archive.hpp"
#include "retiarius/base/error.hpp"
#include "retiarius/measure/frame.hpp"
#include "retiarius/measure/run_measures.hpp"
#include "retiarius/mission/beginning.hpp"
#include "retiarius/mission/step_grid.hpp"

namespace retiarius {

namespace {

using Clock = std::chrono::steady_clock;

// Seconds of wall time: after which a checkpoint is due although no frame was, and between those
// that reach the disk at once. What a resumed run computes does not depend on when they are made.
constexpr double kCheckpointInterval = 30.0;
constexpr double kDurableInterval = 2.0;

bool is_fresh(const Mission& mission, const RunOptions& options) {
  if (options.resume) return options.resume->checkpoint.fresh;
  return mission.net.state.empty() && !options.start;
}

// A checkpoint's content may be nonsense although its bytes are whole.
void check_owners(const std::vector<PairContact>& contacts, std::size_t bodies) {
  const auto known = [&](Index owner) {
    return owner == kNet || (owner >= 0 && static_cast<std::size_t>(owner) < bodies);
  };
  for (const PairContact& contact : contacts)
    if (!known(contact.pair.first_owner) || !known(contact.pair.second_owner))
      throw Error("it has contacts of bodies that the mission does not have");
}

class MissionLoop {
 public:
  MissionLoop(const Mission& mission, const MissionModel& model, Observer& observer,
              const RunOptions& options)
      : mission_(mission),
        observer_(observer),
        options_(options),
        network_(model.network),
        fresh_(is_fresh(mission, options)),
        phases_(make_phases(mission, model, fresh_)),
        simulation_(model.network, model.bodies, first_state(mission, model, options),
                    options.wrap_law),
        measures_(model.network, model.bodies, probe_nodes(mission, model.network)),
        axis_(mission_axis(mission, model.network)),
        rows_(mission.output.interval),
        frames_(mission.output.frame_interval) {
    info_.mission = &mission;
    info_.network = &model.network;
    info_.bodies = &model.bodies;
    info_.choices = choices_of(mission, simulation_);
    info_.start_report = choices_text(info_.choices);
    if (options.resume) go_back(options.resume->checkpoint);
  }

  RunReport run();

 private:
  void go_back(const Checkpoint& saved);
  void transfer(Archive& archive);
  void save(bool durable, bool ended = false);
  void surround(const PhaseSpec& spec);
  void run_phases();
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
  bool stopped() const { return options_.stop && *options_.stop; }

  const Mission& mission_;
  Observer& observer_;
  const RunOptions& options_;
  const Network& network_;
  bool fresh_;
  std::vector<Phase> phases_;
  Simulation simulation_;
  RunMeasures measures_;
  Vec3 axis_;
  OutputGrid rows_, frames_;
  RunModel info_;
  RunReport report_;
  Index phase_index_ = 0;
  bool entered_ = false;  // the phase, in an earlier life of this run
  double phase_start_ = 0.0;
  bool within_step_ = false;  // of the mission, of which a part was taken
  double fraction_ = 0.0;
  std::string broken_;
  bool told_unsettled_ = false;
  Index row_phase_ = 0;
  double energy_scale_ = round_off_energy(network_);  // J
  double first_gravity_energy_ = kInfinity;           // of the phase, J
  Clock::time_point started_ = Clock::now();
  Clock::time_point saved_ = Clock::now(), durable_;
};

RunReport MissionLoop::run() {
  observer_.begin(info_);
  try {
    if (options_.resume) {
      options_.resume->retell(mission_, observer_);
      observer_.resumed();
    }
    run_phases();
  } catch (const Error& e) {
    fail(e.what());
  } catch (const std::bad_alloc&) {
    fail("there is not enough memory to go on");
  }
  try {
    if (phase_index_ == static_cast<Index>(report_.phases.size()))
      leave(phases_[phase_index_], "failed");
    write(true);
    if (report_.outcome == Outcome::finished || report_.outcome == Outcome::broke) save(true, true);
  } catch (const Error& e) {
    fail(e.what());
  }
  report_.measures = measures_.summary();
  report_.work = simulation_.work_times();
  const std::chrono::duration<double> wall = Clock::now() - started_;
  report_.measures.push_back({"wall_time", "s", wall.count()});
  observer_.end(report_);
  return report_;
}

void MissionLoop::run_phases() {
  for (const Index count = static_cast<Index>(phases_.size()); phase_index_ < count;) {
    Phase& phase = phases_[phase_index_];
    if (!entered_) {
      phase_start_ = simulation_.state().time;
      enter(phase, phase_index_ == 0);
      save(true);
    }
    entered_ = false;
    if (!run_phase(phase)) {
      report_.outcome = Outcome::interrupted;
      report_.reason = fmt::format("stopped from outside at {:.6g} s", simulation_.state().time);
      return;
    }
    if (phase_index_ + 1 == count) break;
    ++phase_index_;
  }
  if (broken_.empty()) return;
  report_.outcome = Outcome::broke;
  report_.reason = broken_;
}

// Between two steps: nothing else steers what follows.
void MissionLoop::transfer(Archive& archive) {
  archive(phase_index_);
  if (phase_index_ < 0 || phase_index_ >= static_cast<Index>(phases_.size()))
    throw Error("it is in a phase that the mission does not have");
  std::vector<double> tensions = simulation_.tensions();
  std::vector<PairContact> contacts = simulation_.contacts();
  archive(phase_start_, within_step_, broken_, told_unsettled_, row_phase_, energy_scale_,
          first_gravity_energy_, rows_, frames_, measures_, tensions, contacts);
  if (tensions.size() != network_.segments.size()) throw Error("it has other segments");
  check_owners(contacts, simulation_.bodies().size());
  std::int64_t ended = static_cast<std::int64_t>(report_.phases.size());
  archive(ended);
  report_.phases.resize(static_cast<std::size_t>(ended));
  for (PhaseReport& phase : report_.phases) retiarius::transfer(archive, phase);
  for (const auto& action : phases_[phase_index_].actions) action->transfer(archive);
  if (!archive.reads()) return;
  surround(*phases_[phase_index_].spec);
  simulation_.resume(options_.resume->checkpoint.state, std::move(tensions), std::move(contacts));
}

void MissionLoop::save(bool durable, bool ended) {
  const auto now = Clock::now();
  durable = durable || std::chrono::duration<double>(now - durable_).count() > kDurableInterval;
  Archive archive;
  transfer(archive);
  observer_.save(
      {simulation_.state(), rows_.count(), frames_.count(), ended, fresh_, archive.take()},
      durable);
  saved_ = now;
  if (durable) durable_ = now;
}

// Takes up the run where the checkpoint was made.
void MissionLoop::go_back(const Checkpoint& saved) {
  info_.resumed = true;
  if (saved.ended) throw InputError("the run has come to its end: there is nothing to resume");
  try {
    Archive archive(saved.progress);
    transfer(archive);
    if (!archive.finished()) throw Error("it is longer than its content");
  } catch (const InputError&) {
    throw;
  } catch (const Error& error) {
    throw InputError(fmt::format("the checkpoint does not fit the mission: {}", error.what()));
  }
  entered_ = true;
}

void MissionLoop::surround(const PhaseSpec& spec) {
  simulation_.configure(spec.environment, spec.integrator, spec.contact);
  simulation_.hold_bodies(spec.kind == PhaseKind::fold);
}

// The first failure is the run's reason; what it brings about later is not.
void MissionLoop::fail(const std::string& reason) {
  if (report_.outcome == Outcome::failed) return;
  report_.outcome = Outcome::failed;
  report_.reason = reason;
}

void MissionLoop::enter(Phase& phase, bool first) {
  const PhaseSpec& spec = *phase.spec;
  surround(spec);
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

// False where the run was stopped from outside. Triggers are tested between whole steps.
bool MissionLoop::run_phase(Phase& phase) {
  const bool still = phase.spec->integrator.method == Method::static_solve;
  while (!still && (within_step_ || !phase.trigger.evaluate(trigger_values()))) {
    if (stopped()) {
      save(true);
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
  for (within_step_ = true; within_step_;) {
    const StepReport step =
        simulation_.advance(end, [&](double time) { return prescribe(phase, time); });
    after_step(phase, step);
    within_step_ = !adaptive && simulation_.state().time < end;
    if (within_step_ && stopped()) return;
  }
  bool acted = false;
  for (const auto& action : phase.actions) {
    const auto event = action->next_event(now);
    if (!event || *event > simulation_.state().time + kSameTime) continue;
    action->act(simulation_);
    acted = true;
  }
  if (acted) measures_.set_prescribed(simulation_, moves(phase));
  const std::int64_t frames = frames_.count();
  write(false);
  const std::chrono::duration<double> unsaved = Clock::now() - saved_;
  if (frames_.count() > frames || unsaved.count() > kCheckpointInterval) save(false);
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

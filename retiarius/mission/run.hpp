// Runs a mission: phase after phase, told to an observer.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "retiarius/base/log.hpp"
#include "retiarius/mission/mission.hpp"
#include "retiarius/mission/observer.hpp"
#include "retiarius/motion/stable_step.hpp"
#include "retiarius/state/law.hpp"

namespace retiarius {

// A run that goes on where an earlier one was interrupted or died.
struct Resumption {
  Checkpoint checkpoint;
  // Tells an observer of the rows and frames up to the checkpoint, in their order.
  std::function<void(const Mission&, Observer&)> retell;
};

struct RunOptions {
  // Set from outside (a signal handler, another thread) to end the run after the present step; its
  // outcome is then `interrupted`. May be null.
  const std::atomic<bool>* stop = nullptr;
  // The state that the mission's net.state names, read by whoever can read results: its nodes are
  // where the net starts. Required where net.state is given.
  std::optional<State> net_state;
  // Where the run starts instead of the mission's initial positions; bodies too where there are as
  // many as the mission has. Time and accounts begin anew.
  std::optional<State> start;
  // Goes on from here: what follows is bit for bit what the uninterrupted run would have been. The
  // mission must be the same; start and net_state are not looked at. Throws InputError where the
  // checkpoint does not fit, or belongs to a run that has ended.
  std::optional<Resumption> resume;
  // Sees every law before it joins the simulation; see state/law.hpp. May be empty.
  LawWrapper wrap_law;
  Log log;
};

// What a mission builds before it runs; also what `info` reports.
struct MissionModel {
  Network network;
  std::vector<Body> bodies;
  MissionModel(const Mission& mission);
};

// What a mission will need, known without building it.
struct Estimate {
  double nodes = 0, segments = 0, joints = 0, knots = 0;
  double memory = 0;       // bytes, while it runs
  double frames = 0;       // recorded, where the end is known; else 0
  double frame_bytes = 0;  // of all frames on disk, rough
};
Estimate estimate(const Mission& mission);

// Throws InputError, naming both sizes, where the mission needs more memory than the machine has.
void check_memory(const Estimate& estimate);

// Throws InputError where run_mission would before its first observer call.
void check_run(const Mission& mission, const MissionModel& model, const RunOptions& options = {});

// Runs the mission. Throws InputError before the first observer call where the mission does not fit
// itself (a name that selects nothing, a list of the wrong length); afterwards failures are in the
// report, and the observer has been told everything up to them.
RunReport run_mission(const Mission& mission, const MissionModel& model, Observer& observer,
                      const RunOptions& options = {});

}  // namespace retiarius

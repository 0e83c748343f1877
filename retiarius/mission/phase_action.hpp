// What a phase does to the net while it lasts: grips, shots, prescribed paths.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "retiarius/base/archive.hpp"
#include "retiarius/measure/measures.hpp"
#include "retiarius/mission/mission.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius {

class PhaseAction {
 public:
  virtual ~PhaseAction() = default;

  // At the phase's first instant.
  virtual void begin(Simulation&) {}

  // The next mission time (s) after `now` at which act() wants to be called; a step ends there.
  virtual std::optional<double> next_event(double /*now*/) const { return std::nullopt; }
  virtual void act(Simulation&) {}

  // Adds the nodes that the action moves over the step from the simulation's state to `time`.
  virtual void prescribe(const Simulation&, double /*time*/, std::vector<Prescribed>&) const {}

  // Whether it moves nodes at present (what is held still does not count).
  virtual bool moves() const { return false; }

  // What begin() and act() found or decided, for checkpoints; see base/archive.hpp.
  virtual void transfer(Archive&) {}

  // What the phase's report says of it.
  virtual Measures measures(const Simulation&) const { return {}; }
};

// The direction along which the net is shot in this mission, and the first target's place in the
// list of bodies, which closing needs.
struct MissionFrame {
  Vec3 axis = Vec3::UnitZ();
  Index target = kNone;
  bool fresh = true;  // the net starts as designed, not from a saved state
};

// The actions of a phase: that of its kind, its moves, its fixed nodes. Throws InputError where
// the phase does not fit the network.
std::vector<std::unique_ptr<PhaseAction>> make_actions(const PhaseSpec& phase,
                                                       const Network& network,
                                                       const MissionFrame& frame);

// Each kind's own.
std::unique_ptr<PhaseAction> make_fix(const PhaseSpec& phase, const Network& network);
std::unique_ptr<PhaseAction> make_move(const MoveSpec& move, const PhaseSpec& phase,
                                       const Network& network);
std::unique_ptr<PhaseAction> make_shoot(const PhaseSpec& phase, const Network& network);
std::unique_ptr<PhaseAction> make_fold(const PhaseSpec& phase, const Network& network,
                                       const MissionFrame& frame);
std::unique_ptr<PhaseAction> make_close(const PhaseSpec& phase, const Network& network,
                                        const MissionFrame& frame);

// The initial velocities of the corner masses for a shot, m/s; in the order of
// the corners. Lateral directions are those from the centre in the flat net, turned with the axis.
std::vector<Vec3> shot_velocities(const PhaseSpec& phase, const Network& network);

}  // namespace retiarius

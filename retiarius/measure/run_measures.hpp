// Measures a run while it goes on: history rows, what triggers look at, and the summary.
#pragma once

#include <memory>
#include <vector>

#include "retiarius/measure/capture.hpp"
#include "retiarius/measure/capture_quality.hpp"
#include "retiarius/measure/clearance.hpp"
#include "retiarius/measure/closure.hpp"
#include "retiarius/measure/energy_balance.hpp"
#include "retiarius/measure/history.hpp"
#include "retiarius/measure/measures.hpp"
#include "retiarius/measure/momentum.hpp"
#include "retiarius/measure/peaks.hpp"
#include "retiarius/measure/tension_window.hpp"
#include "retiarius/motion/simulation.hpp"

namespace retiarius {

// Fed by whoever steps the simulation:
//
//   begin            once, before everything, with the simulation configured
//   begin_phase      at each phase's start (the first's included), with its surroundings configured
//   shot             at the first shoot phase's start; later calls change nothing
//   step             after every accepted step, and after a static solve
//
// Mouth, contact and peak measures count from the shot, or from the start without one.
class RunMeasures {
 public:
  // Network and bodies must outlive it. probe_nodes: in the order of the mission's probes.
  RunMeasures(const Network& network, const std::vector<Body>& bodies,
              std::vector<Index> probe_nodes);

  void begin(const Simulation& simulation);

  // prescribed: whether nodes are moved, beyond being held, in this phase.
  void begin_phase(const Simulation& simulation, bool prescribed);

  // For motion that begins or ends within a phase: to be called before the next step. Drifts and
  // closing count while nothing is moved.
  void set_prescribed(const Simulation& simulation, bool prescribed);

  // axis: of the shot, any length but 0; mouth areas are projected along it from now on.
  void shot(const Simulation& simulation, const Vec3& axis);

  void step(const Simulation& simulation, const StepReport& report);

  // Of the present state, which must have been seen by one of the above.
  HistoryRow row(const Simulation& simulation, Index phase) const;

  // A row that belongs to the history: what the capture quality settles to is found from these.
  void keep(const HistoryRow& row);

  double mouth_area() const { return readings_.mouth_area; }  // m2
  // Over the flat net's; 0 where that has no mouth.
  double mouth_ratio() const;
  // Mean displacement of the corners along the axis since the shot, m; 0 before it.
  double travel() const { return travel_; }
  // The mouth's area has fallen 1 % below its largest.
  bool widest() const { return readings_.mouth_area < 0.99 * whole_.mouth_area; }
  // A thread touches or has touched a body.
  bool touched() const { return whole_.first_contact.has_value(); }

  // For checkpoints; see base/archive.hpp.
  void transfer(Archive& archive);

  // The measures of the whole run so far, wall_time excepted.
  Measures summary() const;
  // Those of the present phase alone.
  Measures phase_summary() const;

 private:
  // What the hull of the nodes tells about the first target; empty without one.
  struct Wrapping {
    std::optional<Capture> capture;
    std::optional<double> quality;
  };

  void look(const Simulation& simulation);
  Wrapping wrapping(const std::vector<Vec3>& nodes, const std::vector<BodyState>& poses) const;
  double mean_travel(const std::vector<Vec3>& x) const;
  Vec3 angular_impulse(const Account& account) const;
  void add_drift(const State& state);
  void rebase_drift(const State& state);

  const Network* network_;
  const std::vector<Body>* bodies_;
  std::vector<Index> probe_nodes_;
  double flat_area_, flat_width_;              // m2, m
  std::optional<QualityScale> quality_scale_;  // of the first target
  Settling quality_;                           // since the first contact
  Clearance clearance_;
  Closure closure_;
  EnergyBalance balance_;
  TensionWindow window_;

  Vec3 axis_;
  std::vector<Vec3> shot_corners_;  // places at the shot; empty before it
  bool prescribed_ = false;
  Readings readings_;  // of the last look
  double travel_ = 0.0;
  double time_ = 0.0;
  std::vector<Vec3> nodes_;       // places at the last look
  std::vector<BodyState> poses_;  // of the bodies, then
  Peaks whole_, phase_;
  std::int64_t steps_ = 0, iterations_ = 0, substeps_ = 0, unconverged_ = 0;
  double step_size_ = 0.0;  // s

  Vec3 center_ = Vec3::Zero();  // mass centre at the start
  MomentumDrift linear_, angular_;
};

}  // namespace retiarius

// Advances a State: network, bodies, laws and contact joined under one integrator.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "retiarius/bodies/body.hpp"
#include "retiarius/contact/spec.hpp"
#include "retiarius/forces/bending.hpp"
#include "retiarius/forces/spec.hpp"
#include "retiarius/forces/stretching.hpp"
#include "retiarius/motion/choice.hpp"
#include "retiarius/motion/explicit_stepper.hpp"
#include "retiarius/motion/spec.hpp"
#include "retiarius/motion/step_problem.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/constraints.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// Gives the nodes whose motion is prescribed over the step that ends at `time` (s), ordered by
// node. An empty function prescribes nothing.
using PrescribedMotion = std::function<std::vector<Prescribed>(double time)>;

// What one accepted step took.
struct StepReport {
  double h = 0.0;      // s
  int iterations = 0;  // Newton's, those of failed attempts included
  int halvings = 0;    // before the step was accepted
  int rejections = 0;  // of adaptive steps whose error was too large
  // Local error that an adaptive step expects to have made, over integrator.accuracy.
  double error = 0.0;
  int factorisations = 0;
  int projections = 0;  // of the Hessian
  int substeps = 0;     // of the explicit integrator; 0 by any other
  int unsettled = 0;    // of these, solves of contacts that did not settle
  bool single = false;  // by a single Newton update, which is not converged
};

// The longest sub-step of the explicit integrator, s: integrator.substep, where given, and at most
// nine tenths of the stable step (s; see stable_explicit_step).
double longest_substep(double stable_step, const IntegratorSpec& integrator);
// The smallest number of equal sub-steps of at most that length in a step of length h (s). Throws
// RunError beyond a thousand million.
int explicit_substeps(double stable_step, const IntegratorSpec& integrator, double h);

// The state at the mission's start: the network's initial positions and velocities, bodies' initial
// states.
State initial_state(const Network& network, const std::vector<Body>& bodies);

class Simulation {
 public:
  // Network and bodies must outlive the simulation. `wrap` sees every law before it joins; what the
  // simulation reports of energies and tensions is that of its own laws.
  // solver: of the linear equations; by default the one that suits the net.
  Simulation(const Network& network, const std::vector<Body>& bodies, State state,
             LawWrapper wrap = {}, std::unique_ptr<LinearSolver> solver = make_net_solver());

  // Sets surroundings, integrator and contact for the steps that follow. Throws Error where a
  // single Newton update (see Newton) is asked for and cannot serve. Method::automatic is replaced
  // by what choose() takes.
  void configure(const EnvironmentSpec& environment, const IntegratorSpec& integrator,
                 const ContactSpec& contact);

  // Holds all bodies where they are, neither moving nor falling nor touching, until called with
  // false: a target in orbit has no part in what happens to the net on the ground.
  void hold_bodies(bool held) { bodies_held_ = held; }
  bool bodies_held() const { return bodies_held_; }

  // Goes on from a state of an earlier simulation of the same network and bodies, with the tensions
  // (N) and contacts that its last step reported. To be called after configure().
  void resume(State state, std::vector<double> tensions, std::vector<PairContact> contacts);

  // One accepted step towards time `end` (s); shorter where the whole did not converge, or where
  // the step is adaptive and the whole would be too inaccurate. Throws
  // RunError naming time, node and cause where no step of the smallest allowed length converges;
  // the state is then still the last accepted one.
  StepReport advance(double end, const PrescribedMotion& motion);

  // Static equilibrium with the nodes of `held` at their places. Throws RunError.
  StepReport solve_static(const std::vector<Prescribed>& held);

  // Puts the nodes at rest at given positions: a first shape before anything has moved.
  void place(const std::vector<Vec3>& x);

  // Gives a node a new velocity at once, as a shot does; impulse and work are accounted for.
  void kick(Index node, const Vec3& velocity);

  const State& state() const { return state_; }
  const Network& network() const { return *network_; }
  const std::vector<Body>& bodies() const { return *bodies_; }
  const EnvironmentSpec& environment() const { return environment_; }
  // As configured, with the method that was taken where that was to be chosen.
  const IntegratorSpec& integrator() const { return integrator_; }
  // What would be taken under these settings; of those in force and why.
  Choice choose(const IntegratorSpec& integrator, const ContactSpec& contact) const;
  const Choice& choice() const { return choice_; }

  // Of the last accepted step: each segment's tension, viscous part included, N.
  const std::vector<double>& tensions() const { return tensions_; }
  double stretching_energy() const { return stretching_->energy(state_.x); }             // J
  double bending_energy() const { return bending_ ? bending_->energy(state_.x) : 0.0; }  // J
  // Of barrier contact at the end of the last step, in the order of their pairs.
  const std::vector<PairContact>& contacts() const { return contacts_; }
  double contact_energy() const;  // of the barriers, J
  bool has_barriers() const { return barrier_ != nullptr; }
  const LinearSolver& solver() const { return problem_->solver(); }
  WorkTimes work_times() const { return problem_->work_times(); }

 private:
  void add_law(std::unique_ptr<Law> law);
  StepReport advance_fixed(double end, const PrescribedMotion& motion);
  StepReport advance_adaptive(double end, const PrescribedMotion& motion);
  bool try_step(double end, const PrescribedMotion& motion, StepReport& report,
                std::string& failure);
  StepReport advance_explicitly(double end, const PrescribedMotion& motion);
  bool try_one_stage(double end, const PrescribedMotion& motion, StepReport& report,
                     std::string& failure);
  bool try_two_stages(double end, const PrescribedMotion& motion, StepReport& report,
                      std::string& failure);
  // past_change: of each node's velocity by forces of the past alone, m/s; empty: none.
  bool solve_stage(const Step& step, std::vector<Vec3> predicted,
                   const std::vector<Vec3>& past_change, double end, const PrescribedMotion& motion,
                   StepReport& report, std::string& failure);
  void start_up();
  void follow_paths(const std::vector<Prescribed>& prescribed, const Step& step,
                    std::vector<Vec3>& drift, std::vector<Vec3>& predicted) const;
  void forget_acceleration() { state_.memory.acceleration.clear(); }
  void remember_acceleration(double h);
  double local_error(std::vector<Vec3> error) const;
  std::vector<Vec3> start_acceleration(Exchange& outside);
  void free_bodies(double h, std::vector<BodyState>& result) const;
  double round_off_step() const;
  void check_newton(const IntegratorSpec& integrator, const ContactSpec& contact) const;
  bool reuses_factors() const;
  bool goes_on_accelerating() const;
  double force_floor(const Step& step) const;
  void accept(const Step& step, const std::vector<Prescribed>& prescribed,
              const std::vector<Vec3>& past_change, double end);
  void move_prescribed(const Step& step, const std::vector<Prescribed>& prescribed,
                       const State& old);

  const Network* network_;
  const std::vector<Body>* bodies_;
  EnvironmentSpec environment_;
  IntegratorSpec integrator_;
  Choice choice_;
  WorkCounts work_;
  ContactSpec contact_;
  State state_;
  LawWrapper wrap_;
  std::vector<std::unique_ptr<Law>> laws_;
  Stretching* stretching_ = nullptr;
  BendingLaw* bending_ = nullptr;
  std::size_t lasting_laws_ = 0;
  std::unique_ptr<StepProblem> problem_;
  std::unique_ptr<ContactResponse> response_;
  std::unique_ptr<BarrierContact> barrier_;
  std::vector<PairContact> contacts_;  // of the barrier, at the end of the last step
  std::unique_ptr<ExplicitStepper> explicit_;
  std::unique_ptr<ExplicitContact> explicit_contact_;
  std::vector<double> tensions_;
  // Of the last stage: what the laws alone changed of each node's velocity, m/s; what their outside
  // forces exchanged, as they state it; and what of earlier ones acts on the next stage.
  std::vector<Vec3> law_change_;
  // Memory of a step, kept for the next.
  State old_, next_;
  std::vector<SolvedContact> solved_contacts_;
  std::vector<Vec3> predicted_room_, contact_force_, friction_, residual_, pushes_, end_positions_;
  std::vector<BodyState> free_bodies_;
  ExplicitStepper::Job job_;
  Exchange exchange_, carried_;
  double local_error_ = 0.0;  // of the last adaptive step, over the median rest length
  bool configured_ = false;
  bool bodies_held_ = false;
  double length_scale_ = 0.0;  // median rest length, m
};

}  // namespace retiarius

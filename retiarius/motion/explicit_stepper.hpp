// The explicit integrator: central differences in sub-steps.
#pragma once

#include <memory>
#include <vector>

#include "retiarius/motion/explicit_contact.hpp"
#include "retiarius/motion/sweep_layout.hpp"
#include "retiarius/state/constraints.hpp"
#include "retiarius/state/law.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// Central differences (Stormer, Verlet) in the form kick - drift: velocities live at the middles of
// the sub-steps of length h, and half a kick begins and ends the whole step,
//
//   v(n+1/2) = v(n-1/2) + h F(x(n)) / m,    x(n+1) = x(n) + h v(n+1/2).
//
// Second order, symplectic without damping. Strain rates are backward differences of second order,
// (3 u(n) - 4 u(n-1) + u(n-2)) / 2h of the elongations (taut part where tension-only), which needs
// no velocities; environmental damping takes the mean of the velocities before and after the kick.
class ExplicitStepper {
 public:
  explicit ExplicitStepper(const Network& network);

  // A node's prescribed way over the step: the cubic with these places (m) and velocities (m/s) at
  // its ends.
  struct Way {
    Index node = kNone;
    Vec3 from, to;
    Vec3 start_velocity, end_velocity;
    Vec3 final_velocity;  // that the node has when the step is over
  };
  struct Job {
    double h = 0.0;    // of the whole step, s
    int substeps = 1;  // equal parts
    Vec3 gravity = Vec3::Zero();
    Vec3 body_gravity = Vec3::Zero();
    double damping = 0.0;    // environmental, 1/s
    bool stretches = true;   // false: stretching is among the laws
    std::vector<Law*> laws;  // what else acts, through its gradient: slower
    std::vector<Way> ways;   // ordered by node
    ExplicitContact* contact = nullptr;
  };

  // Moves nodes, touches, support forces and account; the bodies where there is contact. `bodies`
  // in the state are taken as they are at the start, `free` as they end without contact. Throws
  // RunError where a coordinate is no longer finite.
  void run(const Job& job, const std::vector<BodyState>& free, State& state);

  // At the end of the last run: of each segment, N; nothing where the job left out stretching.
  void tensions(std::vector<double>& out) const { layout_->tensions(out); }

 private:
  struct Driven {
    Way way;
    Vec3 x, v;  // at the start of the sub-step
    Vec3 impulse = Vec3::Zero();
  };

  void prepare(const Job& job, const State& state);
  void add_laws(const Job& job, int n, double kick);
  void book_laws(const Job& job, double kick, Account& account);
  void drive(const Job& job, int n, double kick, Account& account);
  void book_damping(const Job& job, double kick, double drift, Account& account);
  void check_finite(const State& state) const;

  const Network* network_;
  double total_mass_ = 0.0;
  std::unique_ptr<SweepLayout> layout_;
  std::vector<Index> alone_;  // that the layout was made for
  kernels::SweepState sweep_{};
  AlignedArray x_, v_;
  std::vector<double> force_, old_v_;
  std::vector<char> held_;
  std::vector<Driven> driven_;
  State at_;  // positions and velocities as the laws see them
  std::vector<Vec3> gradient_, moved_;
  Vec3 momentum_, first_moment_;  // of the net: sums of m v and m x
};

}  // namespace retiarius

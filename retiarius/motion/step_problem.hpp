// The nonlinear problem of one step: minimise the incremental potential of net and bodies under
// constraints.
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Cholesky>

#include "retiarius/bodies/body.hpp"
#include "retiarius/contact/barrier.hpp"
#include "retiarius/contact/response.hpp"
#include "retiarius/motion/work_times.hpp"
#include "retiarius/solve/linear_solver.hpp"
#include "retiarius/solve/newton.hpp"
#include "retiarius/state/constraints.hpp"
#include "retiarius/state/law.hpp"

namespace retiarius {

// Unknowns are the stage positions y of the nodes and, for each free body, a translation and a
// rotation vector b that contact adds to its free motion (both divided by the step's reach). The
// potential is
//
//   1/2 sum m inertia |y - predicted|^2 + sum of the laws' + 1/2 sum inertia b^T M b - friction
//
// Blocked directions follow their targets, so the Newton system is filtered by the projectors
// I - N (Baraff & Witkin 1998); bodies border it with six dense columns each, eliminated by their
// Schur complement. The force that a constraint needs is what remains of the gradient there.
class StepProblem final : public NewtonProblem {
 public:
  StepProblem(std::vector<double> mass, const std::vector<Body>& bodies,
              std::vector<std::unique_ptr<Law>>& laws, std::unique_ptr<LinearSolver> solver);

  // Solves by conjugate gradients from now on, or by the solver given.
  void iterate(bool by_gradients);

  // Looks up the pattern again after laws were added or removed.
  void bind_laws();

  struct Start {
    const Step* step = nullptr;
    std::vector<Vec3> predicted;  // stage that inertia alone would reach
    std::vector<Vec3> guess;      // where the iteration starts
    const std::vector<Prescribed>* prescribed = nullptr;
    std::vector<BodyState> bodies;       // at the step's end, in free motion
    ContactResponse* contact = nullptr;  // null: none
    BarrierContact* barrier = nullptr;   // null: none; not both
    double tolerance = 1e-8;             // of the residual, relative
    double force_floor = 0.0;            // N, round-off of the forces
    bool linear = false;                 // linearise() will be asked for; nodes follow no bodies
  };
  void begin(Start start);
  // The last start, to be filled again: its memory serves the next step.
  Start take_start() { return std::move(start_); }

  double assemble(Projected projected) override;
  bool has_contact() const override { return start_.barrier != nullptr; }
  double evaluate() override;
  double potential() override;
  bool find_direction() override;
  void reuse_direction() override;
  double slope() const override;
  double free_fraction(double wanted) override;
  void move(double fraction) override;
  void keep_direction() override;
  void restore_direction() override;
  void linearise() override;
  double direction_size() const override;
  double residual_ratio() const override;
  double largest_force() const override { return largest_force_; }
  bool revise(bool full) override;

  const std::vector<Vec3>& stage() const { return y_; }
  const std::vector<Vec3>& predicted() const { return start_.predicted; }
  // room: memory to use for them.
  std::vector<Vec3> end_positions(std::vector<Vec3> room = {}) const;
  void end_bodies(std::vector<BodyState>& bodies) const;
  // Gradient: at blocked directions the force of the constraint on the node, elsewhere what the
  // tolerance left, N.
  const std::vector<Vec3>& gradient() const { return gradient_; }
  const std::vector<Constraint>& constraints() const { return constraints_; }
  // Friction on a sliding node at the present iterate, N.
  Vec3 friction_force(const Constraint& c) const;
  // Of the barrier, at the present iterate; none without one.
  void barrier_contacts(std::vector<PairContact>& result);
  // Empty if the straight motion from the step's start to the present iterate keeps apart what
  // touches; otherwise the name of a pair that it does not.
  std::string blocked_motion();
  // What Memory::couplings is to be after this step.
  std::vector<Index> couplings() const;
  // The largest residual and where it is, for messages.
  std::pair<double, Index> largest_residual() const;
  // Directions that were solved for again in this step because of what becomes taut.
  int foreseen_directions() const { return foreseen_directions_; }
  const LinearSolver& solver() const { return *active_; }
  const BlockPattern& pattern() const { return pattern_; }
  const LinearSolver& direct_solver() const { return *solver_; }
  // Of these the search is part of contact, and contact forces are part of assembly.
  const WorkTimes& work_times() const { return times_; }
  // K^-1 M x with the matrix last factorised and inertia M, zero along blocked directions; bodies
  // stay where they are.
  void filter(std::vector<Vec3>& x) const;

 private:
  static constexpr std::size_t kNodes = 4096;  // that a thread takes at once

  // The six columns K N J by which a body borders the matrix. They are nonzero only at the nodes
  // that follow the body and at their neighbours, and kept for those alone.
  struct Border {
    std::vector<Index> nodes;
    std::vector<Mat63> rows;   // of each of `nodes`, transposed
    std::vector<Index> place;  // of each node of the net in `nodes`, or kNone

    Mat63& at(Index node);  // adds the node if it is new
    void clear();
  };

  // The step's end as the barrier sees it.
  struct End {
    std::vector<Vec3> nodes;
    std::vector<BodyState> bodies;
    std::vector<Vec3> turns;
    ContactPlaces places() const { return {&nodes, &bodies, &turns}; }
  };

  double sum_up(Assembly out);
  double add_barrier(Assembly& out);
  double friction_potential() const;
  double add_friction(bool hessian);
  // Whether a pattern's order of elimination is made for it, or that of the one before may stay.
  enum class Order { anew, stays };
  void use_pattern(Order order);
  void grow_pattern();
  void couple(std::vector<std::pair<Index, Index>> couplings, Order order);
  void follow_couplings();
  void free_guess();
  void hold_together(std::vector<Vec3>& end);
  void hold_at_bodies(std::vector<Vec3>& end);
  void relax(std::vector<Vec3>& y) const;
  void find_end(End& end) const;
  double add_inertia(bool hessian);
  void collect_constraints();
  void project_guess();
  Vec3 blocked_stage(const Constraint& c) const;
  void build_borders();
  void build_border_diagonal();
  void add_body_blocks();
  void filter_matrix();
  void keep_rows();
  void restore_rows();
  void foretell_reactions();
  bool factorise(bool again);
  bool solve_anew(bool again);
  void hold();
  void note_direction();
  bool foresees() const;
  bool foresee();
  void note_changes();
  void start_direction();
  void finish_direction();
  void solve_direction(bool again);
  void solve_bordered(bool again);
  const std::vector<Vec6>& reduced_body_gradient() const;
  Mat36 lever_map(const Constraint& c) const;
  Vec3 slip(const Constraint& c) const;

  std::vector<double> mass_;
  const std::vector<Body>* bodies_;
  std::vector<std::unique_ptr<Law>>* laws_;
  std::unique_ptr<LinearSolver> solver_, gradients_;  // the second where it was asked for
  LinearSolver* active_;                              // of the two
  BlockPattern laws_pattern_;                         // what the laws couple
  BlockPattern pattern_;                              // and threads that touch each other
  std::vector<std::pair<Index, Index>> couplings_;    // of those
  Order order_ = Order::anew;                         // of the present pattern
  bool project_contact_ = false;                      // in the present assembly
  struct Neighbour {
    Index slot, node;
    bool row;  // whether this node is the row of the stored block
  };
  std::vector<Index> neighbour_starts_;
  std::vector<Neighbour> neighbours_;

  WorkTimes times_;
  Start start_;
  std::vector<Constraint> constraints_;  // ordered by node
  std::vector<Index> constraint_of_;     // of each node, or kNone
  std::vector<Vec3> slips_before_;       // of each where the last direction began; or empty
  std::vector<Mat6> body_mass_;          // times inertia, N/m and N m
  std::vector<Vec3> y_, base_y_, dy_, gradient_;
  std::vector<Vec3> kept_base_y_, kept_dy_;  // see keep_direction()
  bool one_sided_ = false;                   // whether any law is
  std::vector<Vec3> foreseen_;               // what hold() and foresee() add to the gradient
  std::vector<Mat3> diagonal_before_;        // of the matrix, without what foresee() adds
  std::vector<Index> changed_;  // nodes with blocks of the matrix that foresee() changed
  bool led_here_ = false;       // whether the last direction leads to the present iterate
  int foreseen_directions_ = 0;
  std::vector<Vec6> b_, base_b_, db_, body_gradient_;
  std::vector<Vec6> kept_base_b_, kept_db_;
  mutable std::vector<Vec6> reduced_;  // see reduced_body_gradient()
  mutable std::vector<double> lever_;  // the longest of each body, m
  std::vector<Vec3> end_positions_;    // for contact
  std::vector<BodyState> end_bodies_;
  std::vector<bool> held_;
  std::vector<Vec3> way_sum_;  // see hold_together()
  std::vector<int> way_count_;
  double largest_force_ = 0.0;
  End end_, other_end_;
  std::vector<ContactAssembly::NodeBody> node_body_;  // second derivatives of contact
  std::vector<ContactAssembly::BodyBody> body_body_;
  std::vector<double> largest_parts_;
  BlockMatrix matrix_;
  std::vector<Vec3> reactions_;                  // see foretell_reactions()
  std::vector<Mat3> kept_diagonal_, kept_rows_;  // before the filter; see keep_rows()
  std::vector<Border> borders_;                  // of each body
  std::vector<Index> touching_;                  // bodies that nodes follow, ascending
  std::vector<Mat6> border_diagonal_;            // of each pair of those, row by row
  std::vector<BorderColumns> columns_;           // theirs
  Eigen::MatrixXd products_, schur_;
  Eigen::VectorXd schur_rhs_;
  Eigen::LDLT<Eigen::MatrixXd> schur_factor_;
};

}  // namespace retiarius

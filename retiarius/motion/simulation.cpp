#include "retiarius/motion/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/contact/modified_mass.hpp"
#include "retiarius/forces/environment_damping.hpp"
#include "retiarius/forces/gravity.hpp"
#include "retiarius/motion/barrier_impulses.hpp"
#include "retiarius/motion/contact_impulses.hpp"
#include "retiarius/motion/integrator.hpp"

namespace retiarius {

namespace {

// Convergence at which contacts are first revised. Forces are foretold, and better known than that:
// with 1 at nodes a capture needs a fourth to two fifths fewer iterations than with 0.01. With
// barriers, after each whole step up to this share of a segment's length, whatever the residual.
constexpr double kLooseAtNodes = 1.0;
constexpr double kLooseWithBarriers = 0.01;

// A step that took at most this share of the iterations allowed may be followed by a longer one.
constexpr double kEasyStep = 0.4;

// Newton steps up to this share of a segment's length change the Hessian so little that the next
// one is 0.01 to 0.05 times as long: falling nets of 169 to 8,000 nodes.
constexpr double kChordStep = 0.03;

std::vector<double> node_radii(const Network& network) {
  std::vector<double> radius(network.mass.size(), 0.0);
  for (const Segment& s : network.segments) {
    const double r = network.materials[s.material].radius;
    radius[s.a] = std::max(radius[s.a], r);
    radius[s.b] = std::max(radius[s.b], r);
  }
  return radius;
}

// How often a step is halved until it is no longer than `wanted`; 0: whatever its length.
int halvings_to(double wanted, double whole, int most) {
  int halvings = 0;
  while (wanted > 0.0 && halvings < most && std::ldexp(whole, -halvings) > 1.0001 * wanted)
    ++halvings;
  return halvings;
}

// Books what the laws exchanged. Of outside impulses, `exchange` becomes what acts in this step:
// its own part and what is carried from before.
void book(const Step& step, const Exchange& carried, Exchange& exchange, Account& account) {
  const double share = step.remembers() ? step.reaction_impulse() / step.h : 1.0;
  exchange.outside_impulse = share * exchange.outside_impulse + carried.outside_impulse;
  exchange.outside_angular_impulse =
      share * exchange.outside_angular_impulse + carried.outside_angular_impulse;
  account.material_loss += exchange.material_loss;
  account.environment_loss += exchange.environment_loss;
  account.outside_impulse += exchange.outside_impulse;
  account.outside_angular_impulse += exchange.outside_angular_impulse;
}

}  // namespace

State initial_state(const Network& network, const std::vector<Body>& bodies) {
  State s;
  s.x = network.initial;
  s.v = network.velocity;
  s.support.assign(s.x.size(), Vec3::Zero());
  for (const Body& b : bodies) s.bodies.push_back(b.initial);
  return s;
}

Simulation::Simulation(const Network& network, const std::vector<Body>& bodies, State state,
                       LawWrapper wrap, std::unique_ptr<LinearSolver> solver)
    : network_(&network), bodies_(&bodies), state_(std::move(state)), wrap_(std::move(wrap)) {
  auto stretching = std::make_unique<Stretching>(network);
  stretching_ = stretching.get();
  add_law(std::move(stretching));
  auto bending = std::make_unique<BendingLaw>(network);
  if (!bending->empty()) {
    bending_ = bending.get();
    add_law(std::move(bending));
  }
  lasting_laws_ = laws_.size();
  problem_ = std::make_unique<StepProblem>(network.mass, bodies, laws_, std::move(solver));
  length_scale_ = median_rest_length(network);
  work_ = count_work(network);
  work_.pairs = problem_->pattern().pairs();
  work_.factor_flops = problem_->direct_solver().factor_flops();
  work_.factor_entries = problem_->direct_solver().factor_entries();
  tensions_ = stretching_->tensions(state_.x);
}

void Simulation::add_law(std::unique_ptr<Law> law) {
  laws_.push_back(wrap_ ? wrap_(std::move(law)) : std::move(law));
}

void Simulation::configure(const EnvironmentSpec& environment, const IntegratorSpec& integrator,
                           const ContactSpec& contact) {
  choice_ = choose(integrator, contact);
  // Accelerations belong to the surroundings and the method that they were made with.
  const bool same = environment.gravity == environment_.gravity &&
                    environment.damping == environment_.damping &&
                    choice_.method == integrator_.method && integrator.rho == integrator_.rho;
  if (configured_ && !same) forget_acceleration();
  if (configured_ && integrator.adaptive != integrator_.adaptive) state_.memory.next_step = 0.0;
  configured_ = true;
  environment_ = environment;
  check_newton(integrator, contact);
  integrator_ = integrator;
  integrator_.method = choice_.method;
  contact_ = contact;
  laws_.resize(lasting_laws_);
  if (!environment.gravity.isZero(0.0))
    add_law(std::make_unique<Gravity>(network_->mass, environment.gravity));
  if (environment.damping > 0.0)
    add_law(std::make_unique<EnvironmentDamping>(network_->mass, environment.damping));
  problem_->bind_laws();
  problem_->iterate(choice_.solver == Solver::pcg);
  response_.reset();
  barrier_.reset();
  // What touches goes on touching where the method stays.
  if (contact.method != ContactMethod::barrier) contacts_.clear();
  explicit_contact_.reset();
  if (choice_.method == Method::explicit_differences) {
    if (!explicit_) explicit_ = std::make_unique<ExplicitStepper>(*network_);
    if (contact.method == ContactMethod::modified_mass && !bodies_->empty())
      explicit_contact_ =
          std::make_unique<ExplicitContact>(*bodies_, node_radii(*network_), contact.friction);
    return;
  }
  if (contact.method == ContactMethod::modified_mass && !bodies_->empty())
    response_ =
        std::make_unique<ModifiedMass>(*bodies_, node_radii(*network_), network_->mass, contact);
  if (contact.method == ContactMethod::barrier)
    barrier_ = std::make_unique<BarrierContact>(*network_, *bodies_, contact, integrator.step);
}

// A single update without line search holds where stiffness grows no more than the quadratic model
// foresees; a thread that jumps from slack to taut, or a contact that closes, is not of that kind.
void Simulation::check_newton(const IntegratorSpec& integrator, const ContactSpec& contact) const {
  if (integrator.newton != Newton::single) return;
  if (const std::string why = single_update_refusal(integrator, contact, !bodies_->empty());
      !why.empty())
    throw Error("integrator.newton = \"single\" " + why);
  for (const Material& m : network_->materials)
    if (!m.compression)
      throw Error(
          "integrator.newton = \"single\" needs threads that carry compression: a single "
          "update takes tension-only ones far beyond where they become taut");
}

Choice Simulation::choose(const IntegratorSpec& integrator, const ContactSpec& contact) const {
  return retiarius::choose(work_, integrator, contact, !bodies_->empty());
}

// Where threads may be slack, the Hessian jumps and an old factorisation seldom serves.
bool Simulation::reuses_factors() const {
  return integrator_.solver == Solver::automatic ? work_.compression
                                                 : integrator_.solver == Solver::reuse;
}

// Whether implicit Euler looks for the solution on a parabola instead of a straight way.
// Tension-only threads that have just rebounded do not go on so.
bool Simulation::goes_on_accelerating() const {
  return integrator_.method == Method::implicit_euler && work_.compression &&
         integrator_.newton != Newton::single;
}

// Forces cannot be known better than the rounding of strains lets them: of 1, and of positions
// far from the origin; nor inertia better than the rounding of positions.
double Simulation::force_floor(const Step& step) const {
  double stiffest = 0.0;
  double shortest = kInfinity;
  for (const Segment& s : network_->segments) {
    stiffest = std::max(stiffest, network_->materials[s.material].axial_stiffness);
    shortest = std::min(shortest, s.rest_length);
  }
  double farthest = 0.0;
  for (const Vec3& x : state_.x) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  const double heaviest = *std::max_element(network_->mass.begin(), network_->mass.end());
  const double ulps = std::max(64.0, 4.0 * farthest / shortest);
  return std::numeric_limits<double>::epsilon() *
         (ulps * stiffest + 4.0 * heaviest * step.inertia * farthest);
}

// Updates below the rounding of the largest coordinate, m.
double Simulation::round_off_step() const {
  double farthest = 0.0;
  for (const Vec3& x : state_.x) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  return 4.0 * std::numeric_limits<double>::epsilon() * farthest;
}

double Simulation::contact_energy() const {
  double sum = 0.0;
  for (const PairContact& c : contacts_) sum += c.energy;
  return sum;
}

// Bodies fall exactly and tumble without torque; contact adds to that.
void Simulation::free_bodies(double h, std::vector<BodyState>& result) const {
  result = state_.bodies;
  if (bodies_held_) return;
  for (std::size_t b = 0; b < bodies_->size(); ++b) {
    const Body& body = (*bodies_)[b];
    BodyState& s = result[b];
    s = free_motion(body, state_.bodies[b], h);
    if (!body.fixed) {
      s.position += 0.5 * h * h * environment_.gravity;
      s.velocity += h * environment_.gravity;
    }
  }
}

bool Simulation::solve_stage(const Step& step, std::vector<Vec3> predicted,
                             const std::vector<Vec3>& past_change, double end,
                             const PrescribedMotion& motion, StepReport& report,
                             std::string& failure) {
  const std::vector<Prescribed> prescribed = motion ? motion(end) : std::vector<Prescribed>{};
  StepProblem::Start start = problem_->take_start();
  start.step = &step;
  predicted_room_ = std::exchange(start.predicted, std::move(predicted));
  start.guess = first_guess(integrator_.method, step, std::move(start.guess));
  if (goes_on_accelerating()) {
    const double share = 0.5 * step.h * step.h;
    for (std::size_t i = 0; i < state_.memory.acceleration.size(); ++i)
      start.guess[i] += share * state_.memory.acceleration[i];
  }
  start.prescribed = &prescribed;
  free_bodies(step.h, start.bodies);
  start.contact = bodies_held_ ? nullptr : response_.get();
  start.barrier = barrier_.get();
  if (barrier_) barrier_->leave_bodies_out(bodies_held_);
  start.tolerance = integrator_.tolerance;
  start.force_floor = force_floor(step);
  start.linear = integrator_.newton == Newton::single;
  problem_->begin(std::move(start));
  NewtonSettings settings;
  settings.step_tolerance = integrator_.tolerance * length_scale_;
  if (response_ || barrier_) {
    const double loose = barrier_ ? kLooseWithBarriers : kLooseAtNodes;
    settings.loose_step_tolerance = loose * length_scale_;
    settings.loose_residual_ratio = barrier_ ? kInfinity : loose / integrator_.tolerance;
  }
  settings.round_off_step = round_off_step();
  settings.max_iterations = integrator_.max_iterations;
  settings.reuse = reuses_factors();
  settings.chord_step = kChordStep * length_scale_;
  report.single = integrator_.newton == Newton::single;
  const NewtonResult result =
      report.single ? update_once(*problem_) : minimise(*problem_, settings);
  report.iterations += result.iterations;
  report.factorisations += result.factorisations + problem_->foreseen_directions();
  report.projections += result.projections;
  if (!result.converged) {
    failure = result.failure;
    return false;
  }
  if (const std::string pair = problem_->blocked_motion(); !pair.empty()) {
    failure = fmt::format(
        "the straight way from the step's start to its end leads {} through each "
        "other",
        pair);
    return false;
  }
  accept(step, prescribed, past_change, end);
  return true;
}

bool Simulation::try_step(double end, const PrescribedMotion& motion, StepReport& report,
                          std::string& failure) {
  const double h = end - state_.time;
  carried_ = {};
  const bool done = integrator_.method == Method::tr_bdf2
                        ? try_two_stages(end, motion, report, failure)
                        : try_one_stage(end, motion, report, failure);
  if (done) report.h = h;
  return done;
}

StepReport Simulation::advance(double end, const PrescribedMotion& motion) {
  if (integrator_.method == Method::explicit_differences) return advance_explicitly(end, motion);
  return integrator_.adaptive ? advance_adaptive(end, motion) : advance_fixed(end, motion);
}

// Where barriers had a step cut the next is hardly easier: it begins at the length that went well,
// and after each that goes well at once, in few iterations, at twice that. Adaptive steps have a
// rule of their own; and Newmark's method with contact by modified mass had better get away from
// short steps at once.
StepReport Simulation::advance_fixed(double end, const PrescribedMotion& motion) {
  StepReport report;
  std::string failure;
  const double whole = end - state_.time;
  const bool remembers = barrier_ && !integrator_.adaptive;
  const int first =
      !remembers ? 0 : halvings_to(state_.memory.next_step, whole, integrator_.max_halvings);
  for (report.halvings = first; report.halvings <= integrator_.max_halvings; ++report.halvings) {
    const double part =
        report.halvings == 0 ? end : state_.time + std::ldexp(whole, -report.halvings);
    const int before = report.iterations;
    if (!try_step(part, motion, report, failure)) continue;
    if (!remembers) return report;
    const bool easy = report.iterations - before <= kEasyStep * integrator_.max_iterations;
    const double next = report.halvings > first || !easy ? report.h : 2.0 * report.h;
    state_.memory.next_step = next < integrator_.step ? next : 0.0;
    return report;
  }
  const auto [residual, node] = problem_->largest_residual();
  const Vec3 at = node == kNone ? Vec3(Vec3::Zero()) : problem_->stage()[node];
  throw RunError(fmt::format(
      "the step at time {:.9g} s does not converge, even cut to {:.3g} s: {}; the largest "
      "residual, "
      "{:.3g} N, is at node {} ({:.6g}, {:.6g}, {:.6g}). Try a smaller integrator.step, more "
      "integrator.max_iterations, or another integrator.method",
      state_.time, std::ldexp(whole, -integrator_.max_halvings), failure, residual, node, at.x(),
      at.y(), at.z()));
}

// Turns the solved stage into the next state and books what the step exchanged.
void Simulation::accept(const Step& step, const std::vector<Prescribed>& prescribed,
                        const std::vector<Vec3>& past_change, double end) {
  const State& old = old_ = state_;
  Step done = step;
  done.start = &old;
  const std::vector<Vec3>& y = problem_->stage();
  const std::vector<Vec3>& g = problem_->gradient();
  // Before the state changes, which the problem still sees as the step's start.
  std::vector<Vec3>& force = contact_force_;
  force.clear();
  const bool touches = response_ && !bodies_held_;
  if (touches) {
    for (const Constraint& c : response_->constraints())
      force.push_back(c.blocked * g[c.node] + problem_->friction_force(c));
    response_->contacts(solved_contacts_);
  }
  problem_->barrier_contacts(contacts_);
  std::vector<Vec3>& friction = friction_;
  friction.clear();
  for (const Constraint& c : problem_->constraints())
    friction.push_back(problem_->friction_force(c));
  State& now = state_;
  end_positions_ = problem_->end_positions(std::move(end_positions_));
  now.x.swap(end_positions_);
  problem_->end_bodies(now.bodies);
  // The velocity that goes with the positions, less what Newton's tolerance left as residual:
  // linear momentum is then kept to round-off whatever the tolerance.
  const double weight = step.reaction_impulse();
  std::vector<Vec3>& residual = residual_;
  residual = g;
  const std::vector<Vec3>& predicted = problem_->predicted();
  law_change_.resize(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) {
    // reach (w - v0), which at the predicted stage is what forces of the past still give. Written
    // so, the rounding of positions does not reach the momentum.
    Vec3 change = step.rate * step.reach * (y[i] - predicted[i]);
    if (!past_change.empty()) change += past_change[i];
    now.v[i] = old.v[i] + change;
    law_change_[i] = change - weight / network_->mass[i] * g[i];
  }
  for (std::size_t k = 0; k < friction.size(); ++k) {
    const Constraint& c = problem_->constraints()[k];
    residual[c.node] -= c.blocked * residual[c.node];
    law_change_[c.node] -= weight / network_->mass[c.node] * friction[k];
  }
  for (std::size_t i = 0; i < y.size(); ++i) now.v[i] -= weight / network_->mass[i] * residual[i];
  std::fill(now.support.begin(), now.support.end(), Vec3::Zero());
  move_prescribed(done, prescribed, old);
  now.touches.clear();
  if (touches)
    apply_contact_impulses(done, *bodies_, network_->mass, contact_.friction, solved_contacts_,
                           force, now);
  if (contact_.self) now.memory.couplings = problem_->couplings();
  if (barrier_) {
    apply_barrier_impulses(done, *bodies_, contact_.stick_speed, contacts_, now);
    node_forces(contacts_, y.size(), pushes_);
    for (std::size_t i = 0; i < y.size(); ++i)
      law_change_[i] -= weight / network_->mass[i] * pushes_[i];
  }
  Exchange exchange;
  for (const auto& law : laws_) law->account(done, y, now.x, exchange);
  book(done, carried_, exchange, now.account);
  exchange_ = exchange;
  for (std::size_t b = 0; b < bodies_->size(); ++b) {
    if ((*bodies_)[b].fixed || bodies_held_) continue;
    const Vec3 impulse = step.h * (*bodies_)[b].mass * environment_.gravity;
    now.account.outside_impulse += impulse;
    now.account.outside_angular_impulse +=
        (0.5 * (old.bodies[b].position + now.bodies[b].position)).cross(impulse);
  }
  now.time = end;
  ++now.step;
  stretching_->tensions(y, tensions_);
}

// Puts prescribed nodes on their path, with the impulse and work that this takes.
void Simulation::move_prescribed(const Step& step, const std::vector<Prescribed>& prescribed,
                                 const State& old) {
  const std::vector<Vec3>& y = problem_->stage();
  for (const Prescribed& p : prescribed) {
    const Index i = p.node;
    const double m = network_->mass[i];
    const Vec3 support = m * (p.velocity - old.v[i] - law_change_[i]);
    state_.x[i] = p.position;
    state_.v[i] = p.velocity;
    state_.support[i] = support / step.h;
    state_.account.prescribed_work += support.dot(p.position - old.x[i]) / step.h;
    state_.account.outside_impulse += support;
    state_.account.outside_angular_impulse += y[i].cross(support);
  }
}

void Simulation::resume(State state, std::vector<double> tensions,
                        std::vector<PairContact> contacts) {
  state_ = std::move(state);
  tensions_ = std::move(tensions);
  contacts_ = std::move(contacts);
}

void Simulation::place(const std::vector<Vec3>& x) {
  forget_acceleration();
  state_.x = x;
  std::fill(state_.v.begin(), state_.v.end(), Vec3::Zero());
}

void Simulation::kick(Index node, const Vec3& velocity) {
  forget_acceleration();
  const double m = network_->mass[node];
  const Vec3 impulse = m * (velocity - state_.v[node]);
  state_.account.prescribed_work +=
      0.5 * m * (velocity.squaredNorm() - state_.v[node].squaredNorm());
  state_.account.outside_impulse += impulse;
  state_.account.outside_angular_impulse += state_.x[node].cross(impulse);
  state_.v[node] = velocity;
}

// Relaxation by pseudo-steps of implicit Euler without memory of velocity: short ones find their
// way from the flat, unstrained net, where the stiffness is singular; ever longer ones end as pure
// Newton iterations.
StepReport Simulation::solve_static(const std::vector<Prescribed>& held) {
  StepReport report;
  std::string failure = "the relaxation came to no end";
  double h = integrator_.step;
  constexpr int kMostRelaxations = 400;
  for (int k = 0; k < kMostRelaxations; ++k) {
    const State old = state_;
    const Step step = make_step(Method::static_solve, old, h);
    StepProblem::Start start;
    start.step = &step;
    start.predicted = old.x;
    start.guess = old.x;
    start.prescribed = &held;
    start.bodies = old.bodies;
    start.tolerance = integrator_.tolerance;
    start.force_floor = force_floor(step);
    problem_->begin(std::move(start));
    NewtonSettings settings;
    settings.step_tolerance = integrator_.tolerance * length_scale_;
    settings.round_off_step = round_off_step();
    settings.max_iterations = integrator_.max_iterations;
    settings.reuse = reuses_factors();
    const NewtonResult result = minimise(*problem_, settings);
    report.iterations += result.iterations;
    if (!result.converged) {
      failure = result.failure;
      h *= 0.25;
      continue;
    }
    forget_acceleration();
    state_.x = problem_->stage();
    state_.support = std::vector<Vec3>(state_.x.size(), Vec3::Zero());
    for (const Prescribed& p : held) state_.support[p.node] = problem_->gradient()[p.node];
    double moved = 0.0;
    for (std::size_t i = 0; i < old.x.size(); ++i)
      moved = std::max(moved, (state_.x[i] - old.x[i]).norm());
    // Inertia's share of the balance is m d / h^2; it vanishes as h grows and nothing moves.
    if (moved <= settings.step_tolerance && h > 1e4 * integrator_.step) {
      std::fill(state_.v.begin(), state_.v.end(), Vec3::Zero());
      tensions_ = stretching_->tensions(state_.x);
      return report;
    }
    h *= 4.0;
  }
  throw RunError(
      fmt::format("the static solve found no equilibrium within {} relaxations: {}. Is "
                  "the net held (phase.fix) and loaded?",
                  kMostRelaxations, failure));
}

}  // namespace retiarius

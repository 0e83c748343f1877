#include "retiarius/motion/step_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "retiarius/base/parallel.hpp"
#include "retiarius/base/stopwatch.hpp"

namespace retiarius {

StepProblem::StepProblem(std::vector<double> mass, const std::vector<Body>& bodies,
                         std::vector<std::unique_ptr<Law>>& laws,
                         std::unique_ptr<LinearSolver> solver)
    : mass_(std::move(mass)),
      bodies_(&bodies),
      laws_(&laws),
      solver_(std::move(solver)),
      active_(solver_.get()) {
  const std::size_t n = mass_.size();
  laws_pattern_ = BlockPattern(static_cast<Index>(n));
  for (const auto& law : laws) law->couple(laws_pattern_);
  laws_pattern_.finish();
  pattern_ = laws_pattern_;
  use_pattern(Order::anew);
  constraint_of_.assign(n, kNone);
  gradient_.assign(n, Vec3::Zero());
  dy_.assign(n, Vec3::Zero());
  foreseen_.reserve(n);
  for (const auto& law : laws) one_sided_ |= law->one_sided();
  solver_->keep_parts(one_sided_);
  if (one_sided_) {
    diagonal_before_.reserve(n);
    changed_.reserve(n);
  }
  body_mass_.assign(bodies.size(), Mat6::Zero());
  body_gradient_.assign(bodies.size(), Vec6::Zero());
  borders_.resize(bodies.size());
}

// Everything that depends on the pattern.
void StepProblem::use_pattern(Order order) {
  matrix_.pattern = nullptr;
  order_ = Order::anew;
  solver_->expect_changes(!couplings_.empty());
  if (order == Order::anew)
    solver_->analyse(pattern_);
  else if (solver_->analyse_again(pattern_))
    order_ = Order::stays;
  if (gradients_) gradients_->analyse(pattern_);
  bind_laws();
  const std::size_t n = mass_.size();
  neighbour_starts_.assign(n + 1, 0);
  for (Index c = 0; c < pattern_.blocks(); ++c) {
    for (Index s = pattern_.starts()[c]; s < pattern_.starts()[c + 1]; ++s) {
      ++neighbour_starts_[c + 1];
      ++neighbour_starts_[pattern_.rows()[s] + 1];
    }
  }
  for (std::size_t i = 0; i < n; ++i) neighbour_starts_[i + 1] += neighbour_starts_[i];
  neighbours_.resize(neighbour_starts_[n]);
  std::vector<Index> next(neighbour_starts_.begin(), neighbour_starts_.end() - 1);
  for (Index c = 0; c < pattern_.blocks(); ++c) {
    for (Index s = pattern_.starts()[c]; s < pattern_.starts()[c + 1]; ++s) {
      const Index r = pattern_.rows()[s];
      neighbours_[next[c]++] = {s, r, false};
      neighbours_[next[r]++] = {s, c, true};
    }
  }
}

void StepProblem::iterate(bool by_gradients) {
  if (by_gradients && !gradients_) {
    gradients_ = make_pcg_solver();
    gradients_->analyse(pattern_);
  }
  active_ = by_gradients ? gradients_.get() : solver_.get();
}

void StepProblem::bind_laws() {
  for (const auto& law : *laws_) law->bind(pattern_);
}

void StepProblem::begin(Start start) {
  start_ = std::move(start);
  const Step& step = *start_.step;
  follow_couplings();
  for (const auto& law : *laws_) law->prepare(step);
  for (std::size_t b = 0; b < bodies_->size(); ++b) {
    const Body& body = (*bodies_)[b];
    if (body.fixed) continue;
    body_mass_[b].topLeftCorner<3, 3>() = step.inertia * body.mass * Mat3::Identity();
    body_mass_[b].bottomRightCorner<3, 3>() =
        step.inertia * world_inertia(body, start_.bodies[b].attitude);
  }
  y_ = start_.guess;
  b_.assign(bodies_->size(), Vec6::Zero());
  db_ = b_;
  if (start_.contact) {
    held_.assign(mass_.size(), false);
    for (const Prescribed& p : *start_.prescribed) held_[p.node] = true;
    end_positions_ = end_positions(std::move(end_positions_));
    start_.contact->begin(step, end_positions_, start_.bodies, held_);
  }
  collect_constraints();
  project_guess();
  held_.assign(mass_.size(), false);
  for (const Constraint& c : constraints_) held_[c.node] = true;
  if (foresees()) relax(y_);
  led_here_ = false;
  if (one_sided_ && !start_.linear)
    for (const auto& law : *laws_) law->foretell(step.start->x, step.start->x);
  foreseen_directions_ = 0;
  node_body_.clear();
  body_body_.clear();
  if (start_.barrier) {
    start_.barrier->begin(step, times_.search);
    free_guess();
  }
}

void StepProblem::relax(std::vector<Vec3>& y) const {
  for (const auto& law : *laws_) law->relax(*start_.step, {&mass_, &held_}, y);
}

// Prescribed nodes and contacts in one list, ordered by node; they never share a node.
void StepProblem::collect_constraints() {
  for (const Constraint& c : constraints_) constraint_of_[c.node] = kNone;
  constraints_.clear();
  slips_before_.clear();
  for (const Prescribed& p : *start_.prescribed) {
    Constraint c;
    c.node = p.node;
    c.target = p.position;
    constraints_.push_back(c);
  }
  if (start_.contact) {
    const auto& touching = start_.contact->constraints();
    constraints_.insert(constraints_.end(), touching.begin(), touching.end());
  }
  std::sort(constraints_.begin(), constraints_.end(),
            [](const Constraint& a, const Constraint& b) { return a.node < b.node; });
  for (std::size_t k = 0; k < constraints_.size(); ++k)
    constraint_of_[constraints_[k].node] = static_cast<Index>(k);
}

Mat36 StepProblem::lever_map(const Constraint& c) const {
  Mat36 j;
  j << Mat3::Identity(), -skew(c.lever);
  return j;
}

// Where the blocked directions put the stage.
Vec3 StepProblem::blocked_stage(const Constraint& c) const {
  const Vec3& x0 = start_.step->start->x[c.node];
  Vec3 stage = x0 + (c.target - x0) / start_.step->reach;
  if (c.body != kNone) stage += lever_map(c) * b_[c.body];
  return stage;
}

void StepProblem::project_guess() {
  for (const Constraint& c : constraints_)
    y_[c.node] += c.blocked * (blocked_stage(c) - y_[c.node]);
}

double StepProblem::potential() {
  const Stopwatch watch(times_.assembly);
  const Step& step = *start_.step;
  double value = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i)
    value += mass_[i] * (y_[i] - start_.predicted[i]).squaredNorm();
  value *= 0.5 * step.inertia;
  for (std::size_t b = 0; b < b_.size(); ++b) value += 0.5 * b_[b].dot(body_mass_[b] * b_[b]);
  value += friction_potential();
  for (const auto& law : *laws_) value += law->potential(step, y_);
  if (start_.barrier) {
    const Stopwatch contact(times_.contact);
    find_end(end_);
    value += start_.barrier->evaluate(end_.places(), nullptr) / step.reach;
  }
  return value;
}

double StepProblem::assemble(Projected projected) {
  if (start_.barrier && start_.barrier->touches_itself()) grow_pattern();
  const Stopwatch watch(times_.assembly);
  if (matrix_.pattern != &pattern_) {
    matrix_.reset(pattern_);
  } else {
    matrix_.set_zero();
  }
  project_contact_ = projected != Projected::nothing;
  if (std::exchange(led_here_, false))
    for (const auto& law : *laws_) law->foretell(base_y_, y_);
  return sum_up({&gradient_, &matrix_, projected == Projected::everything});
}

double StepProblem::evaluate() {
  const Stopwatch watch(times_.assembly);
  return sum_up({&gradient_, nullptr, false});
}

// Potential and gradient, and the Hessian where `out` has one, which is zero on entry.
double StepProblem::sum_up(Assembly out) {
  const Step& step = *start_.step;
  std::fill(gradient_.begin(), gradient_.end(), Vec3::Zero());
  double value = 0.0, inertial = 0.0;
  for (const auto& law : *laws_) value += law->assemble(step, y_, out);
  for (std::size_t k = 0; k < b_.size(); ++k) {
    body_gradient_[k] = body_mass_[k] * b_[k];
    value += 0.5 * b_[k].dot(body_gradient_[k]);
  }
  if (out.hessian) {
    node_body_.clear();
    body_body_.clear();
  }
  if (start_.barrier) value += add_barrier(out);
  inertial = add_inertia(out.hessian != nullptr);
  value += 0.5 * step.inertia * inertial;
  value += add_friction(out.hessian != nullptr);
  return value;
}

// Inertia's share of gradient and Hessian; notes the largest force. Returns the sum of m off^2.
double StepProblem::add_inertia(bool hessian) {
  const double inertia = start_.step->inertia;
  largest_parts_.resize((mass_.size() + kNodes - 1) / kNodes);
  const double sum = parallel_sum(mass_.size(), kNodes, [&](std::size_t begin, std::size_t end) {
    double part = 0.0, largest = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 off = y_[i] - start_.predicted[i];
      const Vec3 force = inertia * mass_[i] * off;
      part += mass_[i] * off.squaredNorm();
      largest = std::max({largest, gradient_[i].squaredNorm(), force.squaredNorm()});
      gradient_[i] += force;
      if (hessian) matrix_.diagonal[i].diagonal().array() += inertia * mass_[i];
    }
    largest_parts_[begin / kNodes] = largest;
    return part;
  });
  double largest = 0.0;
  for (const double part : largest_parts_) largest = std::max(largest, part);
  largest_force_ = std::sqrt(largest);
  return sum;
}

// The gradient with respect to each body's unknowns, with the nodes that follow it and what is
// foreseen to act on these.
const std::vector<Vec6>& StepProblem::reduced_body_gradient() const {
  std::vector<Vec6>& g = reduced_;
  g = body_gradient_;
  for (const Constraint& c : constraints_) {
    if (c.body == kNone) continue;
    Vec3 force = gradient_[c.node];
    if (!foreseen_.empty()) force += foreseen_[c.node];
    g[c.body] += lever_map(c).transpose() * (c.blocked * force);
  }
  return g;
}

// P K P with the blocked directions held by a diagonal of the block's own size.
void StepProblem::filter_matrix() {
  for (const Constraint& c : constraints_) {
    const Mat3 free = Mat3::Identity() - c.blocked;
    Mat3& diagonal = matrix_.diagonal[c.node];
    const double scale = std::max(std::abs(diagonal.trace()) / 3.0, 1e-300);
    diagonal = free * diagonal * free + scale * c.blocked;
    for (Index s = neighbour_starts_[c.node]; s < neighbour_starts_[c.node + 1]; ++s) {
      const Neighbour& n = neighbours_[s];
      Mat3& block = matrix_.below[n.slot];
      block = n.row ? Mat3(free * block) : Mat3(block * free);
    }
    for (const Index body : touching_) {
      Border& border = borders_[body];
      const Index place = border.place[c.node];
      if (place != kNone) border.rows[place] = (border.rows[place] * free).eval();
    }
  }
}

void StepProblem::filter(std::vector<Vec3>& x) const {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] *= start_.step->inertia * mass_[i];
  for (const Constraint& c : constraints_) x[c.node] -= c.blocked * x[c.node];
  active_->solve(x);
  for (const Constraint& c : constraints_) x[c.node] -= c.blocked * x[c.node];
}

double StepProblem::slope() const {
  double sum = parallel_sum(dy_.size(), kNodes, [&](std::size_t begin, std::size_t end) {
    double part = 0.0;
    for (std::size_t i = begin; i < end; ++i) part += gradient_[i].dot(dy_[i]);
    return part;
  });
  for (std::size_t b = 0; b < db_.size(); ++b) sum += body_gradient_[b].dot(db_[b]);
  return sum;
}

void StepProblem::move(double fraction) {
  parallel_for(y_.size(), kNodes, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) y_[i] = base_y_[i] + fraction * dy_[i];
  });
  for (std::size_t b = 0; b < b_.size(); ++b) b_[b] = base_b_[b] + fraction * db_[b];
}

// The diagonal blocks of constrained nodes, and those that couple each to its neighbours, one after
// the other.
void StepProblem::keep_rows() {
  kept_diagonal_.clear();
  kept_rows_.clear();
  for (const Constraint& c : constraints_) {
    kept_diagonal_.push_back(matrix_.diagonal[c.node]);
    for (Index s = neighbour_starts_[c.node]; s < neighbour_starts_[c.node + 1]; ++s) {
      const Mat3& block = matrix_.below[neighbours_[s].slot];
      kept_rows_.push_back(neighbours_[s].row ? Mat3(block) : Mat3(block.transpose()));
    }
  }
}

// Undoes filter_matrix().
void StepProblem::restore_rows() {
  const Mat3 *diagonal = kept_diagonal_.data(), *row = kept_rows_.data();
  for (const Constraint& c : constraints_) {
    matrix_.diagonal[c.node] = *diagonal++;
    for (Index s = neighbour_starts_[c.node]; s < neighbour_starts_[c.node + 1]; ++s, ++row) {
      const Neighbour& n = neighbours_[s];
      matrix_.below[n.slot] = n.row ? *row : Mat3(row->transpose());
    }
  }
}

void StepProblem::linearise() {
  std::fill(gradient_.begin(), gradient_.end(), Vec3::Zero());
  for (const Constraint& c : constraints_) gradient_[c.node] = reactions_[c.node];
}

double StepProblem::direction_size() const {
  double largest = 0.0;
  for (const Vec3& d : dy_) largest = std::max(largest, d.squaredNorm());
  return std::sqrt(largest);
}

std::pair<double, Index> StepProblem::largest_residual() const {
  double largest = 0.0;
  Index where = kNone;
  for (std::size_t i = 0; i < gradient_.size(); ++i) {
    Vec3 r = gradient_[i];
    if (constraint_of_[i] != kNone) r -= constraints_[constraint_of_[i]].blocked * r;
    if (!r.allFinite()) return {kInfinity, static_cast<Index>(i)};
    if (r.squaredNorm() <= largest) continue;
    largest = r.squaredNorm();
    where = static_cast<Index>(i);
  }
  return {std::sqrt(largest), where};
}

double StepProblem::residual_ratio() const {
  double largest = largest_residual().first;
  if (bodies_->empty())
    return largest / std::max(start_.tolerance * largest_force_, start_.force_floor);
  // A moment counts as the force at the longest lever that transmits it.
  std::vector<double>& lever = lever_;
  lever.assign(bodies_->size(), 0.0);
  for (const Constraint& c : constraints_)
    if (c.body != kNone) lever[c.body] = std::max(lever[c.body], c.lever.norm());
  double floor = start_.force_floor;
  if (start_.barrier) {
    floor += start_.barrier->force_round_off();
    for (std::size_t b = 0; b < lever.size(); ++b)
      lever[b] = start_.barrier->scene().bodies[b].bounding_radius;
  }
  const std::vector<Vec6>& gradients = reduced_body_gradient();
  for (std::size_t b = 0; b < gradients.size(); ++b) {
    largest = std::max(largest, gradients[b].head<3>().norm());
    if (lever[b] > 0.0) largest = std::max(largest, gradients[b].tail<3>().norm() / lever[b]);
  }
  return largest / std::max(start_.tolerance * largest_force_, floor);
}

bool StepProblem::revise(bool full) {
  if (start_.barrier) {
    find_end(end_);
    return start_.barrier->revise(end_.places(), full);
  }
  if (!start_.contact) return false;
  end_positions_ = end_positions(std::move(end_positions_));
  end_bodies(end_bodies_);
  const std::vector<Vec3>& reaction = full ? gradient_ : reactions_;
  if (!start_.contact->revise(end_positions_, end_bodies_, reaction, full)) return false;
  collect_constraints();
  project_guess();
  return true;
}

std::vector<Vec3> StepProblem::end_positions(std::vector<Vec3> room) const {
  const Step& step = *start_.step;
  std::vector<Vec3> x1 = std::move(room);
  x1 = y_;
  if (step.reach == 1.0) return x1;
  for (std::size_t i = 0; i < y_.size(); ++i)
    x1[i] = step.start->x[i] + step.reach * (y_[i] - step.start->x[i]);
  return x1;
}

void StepProblem::end_bodies(std::vector<BodyState>& result) const {
  result = start_.bodies;
  for (std::size_t b = 0; b < result.size(); ++b) {
    const Vec6 d = start_.step->reach * b_[b];
    if ((*bodies_)[b].fixed || d.isZero(0.0)) continue;
    result[b] = displaced(result[b], d.head<3>(), d.tail<3>());
  }
}

}  // namespace retiarius

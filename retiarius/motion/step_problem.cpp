#include "retiarius/motion/step_problem.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/base/stopwatch.hpp"

namespace retiarius {

StepProblem::StepProblem(std::vector<double> mass, const std::vector<Body>& bodies,
                         std::vector<std::unique_ptr<Law>>& laws,
                         std::unique_ptr<LinearSolver> solver)
    : mass_(std::move(mass)), bodies_(&bodies), laws_(&laws), solver_(std::move(solver)) {
  const std::size_t n = mass_.size();
  laws_pattern_ = BlockPattern(static_cast<Index>(n));
  for (const auto& law : laws) law->couple(laws_pattern_);
  laws_pattern_.finish();
  pattern_ = laws_pattern_;
  use_pattern();
  constraint_of_.assign(n, kNone);
  gradient_.assign(n, Vec3::Zero());
  dy_.assign(n, Vec3::Zero());
  body_mass_.assign(bodies.size(), Mat6::Zero());
  body_gradient_.assign(bodies.size(), Vec6::Zero());
  borders_.resize(bodies.size());
}

// Everything that depends on the pattern.
void StepProblem::use_pattern() {
  matrix_.pattern = nullptr;
  solver_->analyse(pattern_);
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

void StepProblem::bind_laws() {
  for (const auto& law : *laws_) law->bind(pattern_);
}

void StepProblem::begin(Start start) {
  start_ = std::move(start);
  const Step& step = *start_.step;
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
    std::vector<bool> held(mass_.size(), false);
    for (const Prescribed& p : *start_.prescribed) held[p.node] = true;
    start_.contact->begin(step, end_positions(), start_.bodies, held);
  }
  collect_constraints();
  project_guess();
  node_body_.clear();
  body_body_.clear();
  if (start_.barrier) {
    start_.barrier->begin(step);
    free_guess();
  }
}

// Prescribed nodes and contacts in one list, ordered by node; they never share a node.
void StepProblem::collect_constraints() {
  for (const Constraint& c : constraints_) constraint_of_[c.node] = kNone;
  constraints_.clear();
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
  for (const Constraint& c : constraints_) {
    if (c.limit > 0.0) value += c.limit / step.reach * std::hypot(slip(c).norm(), c.smoothing);
  }
  for (const auto& law : *laws_) value += law->potential(step, y_);
  if (start_.barrier) {
    const Stopwatch contact(times_.contact);
    find_end(end_);
    value += start_.barrier->evaluate(end_.places(), nullptr) / step.reach;
  }
  return value;
}

double StepProblem::assemble(bool definite) {
  if (start_.barrier && start_.barrier->touches_itself()) grow_pattern();
  const Stopwatch watch(times_.assembly);
  if (matrix_.pattern != &pattern_) {
    matrix_.reset(pattern_);
  } else {
    matrix_.set_zero();
  }
  return sum_up({&gradient_, &matrix_, definite});
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
  for (std::size_t b = 0; b < b_.size(); ++b) body_gradient_[b] = body_mass_[b] * b_[b];
  for (std::size_t b = 0; b < b_.size(); ++b) value += 0.5 * b_[b].dot(body_gradient_[b]);
  if (start_.barrier) value += add_barrier(out);
  double largest = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const Vec3 off = y_[i] - start_.predicted[i];
    const Vec3 inertia = step.inertia * mass_[i] * off;
    inertial += mass_[i] * off.squaredNorm();
    largest = std::max({largest, gradient_[i].squaredNorm(), inertia.squaredNorm()});
    gradient_[i] += inertia;
    if (out.hessian) matrix_.diagonal[i].diagonal().array() += step.inertia * mass_[i];
  }
  largest_force_ = std::sqrt(largest);
  value += 0.5 * step.inertia * inertial;
  for (const Constraint& c : constraints_) {
    if (c.limit <= 0.0) continue;
    const Vec3 u = slip(c);
    const double size = std::hypot(u.norm(), c.smoothing);
    const Vec3 force = -c.limit / size * u;
    value += c.limit / step.reach * size;
    gradient_[c.node] -= force;
    // The body's share of the second derivatives is left out: it is heavy against one node.
    if (out.hessian)
      matrix_.diagonal[c.node] +=
          (c.limit * step.reach / size) *
          (Mat3::Identity() - c.blocked - u * u.transpose() / (size * size));
    if (c.body != kNone) body_gradient_[c.body] += lever_map(c).transpose() * force;
  }
  return value;
}

// Displacement of a sliding node along the surface, relative to the body, over the step, m.
Vec3 StepProblem::slip(const Constraint& c) const {
  const Step& step = *start_.step;
  const Vec3& x0 = step.start->x[c.node];
  Vec3 u = x0 + step.reach * (y_[c.node] - x0) - c.carried;
  if (c.body != kNone) u -= step.reach * (lever_map(c) * b_[c.body]);
  return u - c.blocked * u;
}

Vec3 StepProblem::friction_force(const Constraint& c) const {
  if (c.limit <= 0.0) return Vec3::Zero();
  const Vec3 u = slip(c);
  return -c.limit / std::hypot(u.norm(), c.smoothing) * u;
}

// The gradient with respect to each body's unknowns, with the nodes that follow it.
std::vector<Vec6> StepProblem::reduced_body_gradient() const {
  std::vector<Vec6> g = body_gradient_;
  for (const Constraint& c : constraints_) {
    if (c.body != kNone) g[c.body] += lever_map(c).transpose() * (c.blocked * gradient_[c.node]);
  }
  return g;
}

Mat63& StepProblem::Border::at(Index node) {
  if (place[node] == kNone) {
    place[node] = static_cast<Index>(nodes.size());
    nodes.push_back(node);
    rows.push_back(Mat63::Zero());
  }
  return rows[place[node]];
}

void StepProblem::Border::clear() {
  for (const Index node : nodes) place[node] = kNone;
  nodes.clear();
  rows.clear();
}

// The columns K N J of the bodies that touch.
void StepProblem::build_borders() {
  for (const Index body : touching_) borders_[body].clear();
  touching_.clear();
  for (const Constraint& c : constraints_) {
    if (c.body == kNone) continue;
    Border& border = borders_[c.body];
    if (border.place.empty()) border.place.assign(mass_.size(), kNone);
    if (border.nodes.empty()) touching_.push_back(c.body);
    const Mat63 follows = lever_map(c).transpose() * c.blocked;
    border.at(c.node) += follows * matrix_.diagonal[c.node].transpose();
    for (Index s = neighbour_starts_[c.node]; s < neighbour_starts_[c.node + 1]; ++s) {
      const Neighbour& n = neighbours_[s];
      const Mat3& block = matrix_.below[n.slot];
      border.at(n.node) += n.row ? Mat63(follows * block) : Mat63(follows * block.transpose());
    }
  }
  for (const ContactAssembly::NodeBody& e : node_body_) {
    Border& border = borders_[e.body];
    if (border.place.empty()) border.place.assign(mass_.size(), kNone);
    border.at(e.node) += e.block.transpose();
  }
  for (const ContactAssembly::BodyBody& e : body_body_)
    touching_.insert(touching_.end(), {e.first, e.second});
  for (const ContactAssembly::NodeBody& e : node_body_) touching_.push_back(e.body);
  std::sort(touching_.begin(), touching_.end());
  touching_.erase(std::unique(touching_.begin(), touching_.end()), touching_.end());
  for (const Index body : touching_) {
    Border& border = borders_[body];
    if (border.place.empty()) border.place.assign(mass_.size(), kNone);
  }
  build_border_diagonal();
}

// The blocks J^T N K N J of each pair of bodies that touch, with the bodies' masses.
void StepProblem::build_border_diagonal() {
  const std::size_t count = touching_.size();
  border_diagonal_.assign(count * count, Mat6::Zero());
  for (std::size_t p = 0; p < count; ++p) {
    border_diagonal_[p * count + p] = body_mass_[touching_[p]];
    for (const Constraint& c : constraints_) {
      if (c.body != touching_[p]) continue;
      const Mat63 follows = lever_map(c).transpose() * c.blocked;
      for (std::size_t q = 0; q < count; ++q) {
        const Border& border = borders_[touching_[q]];
        const Index place = border.place[c.node];
        if (place == kNone) continue;
        border_diagonal_[p * count + q] += follows * border.rows[place].transpose();
      }
    }
  }
  const auto place_of = [&](Index body) {
    return static_cast<std::size_t>(std::lower_bound(touching_.begin(), touching_.end(), body) -
                                    touching_.begin());
  };
  for (const ContactAssembly::BodyBody& e : body_body_) {
    const std::size_t p = place_of(e.first), q = place_of(e.second);
    border_diagonal_[p * count + q] += e.block;
    if (p != q) border_diagonal_[q * count + p] += e.block.transpose();
  }
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

bool StepProblem::find_direction() {
  if (!factorise()) return false;
  solve_for_direction();
  return dy_.empty() ||
         std::all_of(dy_.begin(), dy_.end(), [](const Vec3& d) { return d.allFinite(); });
}

bool StepProblem::factorise() {
  const Stopwatch watch(times_.factor);
  build_borders();
  filter_matrix();
  if (!solver_->factor(matrix_)) return false;
  if (!touching_.empty()) {
    solve_border_columns();
    build_schur();
  }
  return true;
}

void StepProblem::reuse_direction() { solve_for_direction(); }

// The direction for the present gradient with the present factorisation and borders.
void StepProblem::solve_for_direction() {
  const Stopwatch watch(times_.solve);
  base_y_ = y_;
  base_b_ = b_;
  for (std::size_t i = 0; i < dy_.size(); ++i) dy_[i] = -gradient_[i];
  for (const Constraint& c : constraints_) dy_[c.node] -= c.blocked * dy_[c.node];
  // A body that nothing touches any more goes back to its free motion.
  for (std::size_t b = 0; b < b_.size(); ++b) db_[b] = -b_[b];
  solver_->solve(dy_);
  if (!touching_.empty()) solve_bordered();
  for (const Constraint& c : constraints_) {
    dy_[c.node] -= c.blocked * dy_[c.node];
    if (c.body != kNone) dy_[c.node] += c.blocked * (lever_map(c) * db_[c.body]);
  }
}

// A^-1 B, one column after the other.
void StepProblem::solve_border_columns() {
  const std::size_t n = dy_.size();
  columns_.assign(6 * touching_.size() * n, Vec3::Zero());
  Vec3* first = columns_.data();
  for (const Index body : touching_) {
    const Border& border = borders_[body];
    for (int k = 0; k < 6; ++k, first += n) {
      for (std::size_t t = 0; t < border.nodes.size(); ++t) {
        first[border.nodes[t]] = border.rows[t].row(k).transpose();
      }
    }
  }
  solver_->solve(columns_);
}

// B^T x for the columns of one touching body.
Vec6 StepProblem::border_times(std::size_t body, const Vec3* x) const {
  const Border& border = borders_[touching_[body]];
  Vec6 sum = Vec6::Zero();
  for (std::size_t t = 0; t < border.nodes.size(); ++t) {
    sum.noalias() += border.rows[t] * x[border.nodes[t]];
  }
  return sum;
}

// The bodies' Schur complement D - B^T A^-1 B, factorised.
void StepProblem::build_schur() {
  const std::size_t n = dy_.size(), count = touching_.size();
  const Eigen::Index size = static_cast<Eigen::Index>(6 * count);
  schur_.resize(size, size);
  for (std::size_t p = 0; p < count; ++p) {
    const Eigen::Index row = static_cast<Eigen::Index>(6 * p);
    for (std::size_t q = 0; q < count; ++q) {
      for (int l = 0; l < 6; ++l) {
        const std::size_t column = 6 * q + static_cast<std::size_t>(l);
        schur_.block<6, 1>(row, static_cast<Eigen::Index>(column)) =
            border_diagonal_[p * count + q].col(l) - border_times(p, columns_.data() + column * n);
      }
    }
  }
  schur_factor_.compute(0.5 * (schur_ + schur_.transpose()));
}

// A dy + B db = r for the net and B^T dy + D db = -g_b for the bodies, with A^-1 r in dy on entry.
void StepProblem::solve_bordered() {
  const std::size_t n = dy_.size();
  const std::vector<Vec6> body_gradient = reduced_body_gradient();
  schur_rhs_.resize(static_cast<Eigen::Index>(6 * touching_.size()));
  for (std::size_t p = 0; p < touching_.size(); ++p) {
    schur_rhs_.segment<6>(static_cast<Eigen::Index>(6 * p)) =
        -body_gradient[touching_[p]] - border_times(p, dy_.data());
  }
  schur_factor_.solveInPlace(schur_rhs_);
  for (std::size_t p = 0; p < touching_.size(); ++p) {
    db_[touching_[p]] = schur_rhs_.segment<6>(static_cast<Eigen::Index>(6 * p));
  }
  for (std::size_t i = 0; i < n; ++i) {
    Vec3 d = dy_[i];
    for (Eigen::Index m = 0; m < schur_rhs_.size(); ++m) {
      d -= schur_rhs_(m) * columns_[static_cast<std::size_t>(m) * n + i];
    }
    dy_[i] = d;
  }
}

void StepProblem::filter(std::vector<Vec3>& x) const {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] *= start_.step->inertia * mass_[i];
  for (const Constraint& c : constraints_) x[c.node] -= c.blocked * x[c.node];
  solver_->solve(x);
  for (const Constraint& c : constraints_) x[c.node] -= c.blocked * x[c.node];
}

double StepProblem::slope() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < dy_.size(); ++i) sum += gradient_[i].dot(dy_[i]);
  for (std::size_t b = 0; b < db_.size(); ++b) sum += body_gradient_[b].dot(db_[b]);
  return sum;
}

void StepProblem::move(double fraction) {
  for (std::size_t i = 0; i < y_.size(); ++i) y_[i] = base_y_[i] + fraction * dy_[i];
  for (std::size_t b = 0; b < b_.size(); ++b) b_[b] = base_b_[b] + fraction * db_[b];
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
  // A moment counts as the force at the longest lever that transmits it.
  std::vector<double> lever(bodies_->size(), 0.0);
  for (const Constraint& c : constraints_)
    if (c.body != kNone) lever[c.body] = std::max(lever[c.body], c.lever.norm());
  double floor = start_.force_floor;
  if (start_.barrier) {
    floor += start_.barrier->force_round_off();
    for (std::size_t b = 0; b < lever.size(); ++b)
      lever[b] = start_.barrier->scene().bodies[b].bounding_radius;
  }
  const std::vector<Vec6> gradients = reduced_body_gradient();
  for (std::size_t b = 0; b < gradients.size(); ++b) {
    largest = std::max(largest, gradients[b].head<3>().norm());
    if (lever[b] > 0.0) largest = std::max(largest, gradients[b].tail<3>().norm() / lever[b]);
  }
  return largest / std::max(start_.tolerance * largest_force_, floor);
}

bool StepProblem::revise(bool full) {
  if (start_.barrier) {
    find_end(end_);
    return full && start_.barrier->revise(end_.places());
  }
  if (!start_.contact) return false;
  if (!start_.contact->revise(end_positions(), end_bodies(), gradient_, full)) return false;
  collect_constraints();
  project_guess();
  return true;
}

std::vector<Vec3> StepProblem::end_positions() const {
  const Step& step = *start_.step;
  if (step.reach == 1.0) return y_;
  std::vector<Vec3> x1(y_.size());
  for (std::size_t i = 0; i < y_.size(); ++i)
    x1[i] = step.start->x[i] + step.reach * (y_[i] - step.start->x[i]);
  return x1;
}

std::vector<BodyState> StepProblem::end_bodies() const {
  std::vector<BodyState> result = start_.bodies;
  for (std::size_t b = 0; b < result.size(); ++b) {
    const Vec6 d = start_.step->reach * b_[b];
    if ((*bodies_)[b].fixed || d.isZero(0.0)) continue;
    result[b] = displaced(result[b], d.head<3>(), d.tail<3>());
  }
  return result;
}

}  // namespace retiarius

#include "retiarius/motion/explicit_contact.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "retiarius/bodies/free_rotation.hpp"

namespace retiarius {

namespace {

// All shares of the thread's radius: how far a plane serves, within which gap a node is watched
// at every sub-step, beyond which it is let go, and how much depth is undone in one sub-step.
constexpr double kPlaneReach = 0.01;
constexpr double kNear = 0.5;
constexpr double kFar = 1.0;
constexpr double kMostShift = 0.1;
// Cosine between normals of one side of a body.
constexpr double kSameSide = 0.5;
constexpr int kMostPathSteps = 400;
// Contacts take turns until none changes by this share of the largest.
constexpr int kMostTurns = 400;
constexpr double kTurnTolerance = 1e-10;

}  // namespace

ExplicitContact::ExplicitContact(const std::vector<Body>& bodies, std::vector<double> radius,
                                 double friction)
    : bodies_(&bodies), radius_(std::move(radius)), friction_(friction) {}

void ExplicitContact::begin(const Nodes& nodes, const State& start, double h) {
  nodes_ = nodes;
  h_ = h;
  poses_ = old_poses_ = start.bodies;
  free_.assign(bodies_->size(), {});
  any_free_ = false;
  for (std::size_t b = 0; b < free_.size(); ++b) {
    any_free_ |= !(*bodies_)[b].fixed;
    refresh(static_cast<Index>(b));
  }
  const auto size = static_cast<std::size_t>(nodes.layout->size());
  origin_.assign(size, 0.0);
  limit_.assign(size, kInfinity);
  found_.resize(size / 8);
  until_.assign(radius_.size(), kInfinity);
  contacts_.clear();
  contacts_.reserve(radius_.size() * bodies_->size());
  drift_ = 0.0;
  for (std::size_t i = 0; i < radius_.size(); ++i) {
    const Index node = static_cast<Index>(i);
    if ((*nodes_.held)[i]) continue;
    for (std::size_t b = 0; b < free_.size(); ++b) {
      const Index body = static_cast<Index>(b);
      if (lower_gap(node, body) > kNear * radius_[i]) continue;
      Contact c;
      c.node = node;
      c.body = body;
      query(c, inward(body, poses_[b], nodes_.layout->read(nodes_.x, node)));
      c.place = c.anchor = c.origin;
      c.gap = c.distance - radius_[i];
      if (c.gap > kNear * radius_[i]) continue;
      c.relative = relative_velocity(c);
      c.fresh = false;
      contacts_.push_back(c);
    }
  }
  for (const Touch& t : start.touches) {
    for (Contact& c : contacts_)
      if (c.node == t.node && c.body == t.body) c.sticks = t.sticks;
  }
  guard_all();
}

// What follows from a body's pose.
void ExplicitContact::refresh(Index body) {
  const Body& b = (*bodies_)[body];
  Free& f = free_[body];
  if (b.fixed) return;
  f.inverse_mass = 1.0 / b.mass;
  const Mat3 turn = poses_[body].attitude.toRotationMatrix();
  f.inverse_inertia = turn * b.inertia.inverse() * turn.transpose();
  f.spin = f.inverse_inertia * poses_[body].angular_momentum;
}

// Kick and drift; the spin is that of the drift's middle.
void ExplicitContact::move_bodies(const Vec3& gravity, double kick) {
  if (!any_free_) return;
  double fastest = 0.0;
  for (std::size_t b = 0; b < free_.size(); ++b) {
    old_poses_[b] = poses_[b];
    if ((*bodies_)[b].fixed) continue;
    const Index body = static_cast<Index>(b);
    BodyState& pose = poses_[b];
    pose.velocity += kick * gravity;
    pose.position += h_ * pose.velocity;
    if (!pose.angular_momentum.isZero(0.0)) {
      const Quat start = pose.attitude;
      pose.attitude = rotation(0.5 * h_ * free_[b].spin) * start;
      refresh(body);
      pose.attitude = (rotation(h_ * free_[b].spin) * start).normalized();
      refresh(body);
    }
    const double reach = (*bodies_)[b].shape->bounding_radius();
    fastest = std::max(fastest, pose.velocity.norm() + reach * free_[b].spin.norm());
  }
  drift_ += h_ * fastest;
}

double ExplicitContact::gap_to(Index node, Index body) const {
  const Vec3 at = to_body(poses_[body], nodes_.layout->read(nodes_.x, node));
  return (*bodies_)[body].shape->nearest(at).distance - radius_[node];
}

// A bound of the gap from below, m, cheap where the node is far.
double ExplicitContact::lower_gap(Index node, Index body) const {
  const double reach = (*bodies_)[body].shape->bounding_radius();
  if (std::isfinite(reach)) {
    const double far = (nodes_.layout->read(nodes_.x, node) - poses_[body].position).norm() - reach;
    if (far > 0.1 * reach + radius_[node]) return far - radius_[node];
  }
  return gap_to(node, body);
}

bool ExplicitContact::active(Index node, Index body) const {
  const auto found = std::lower_bound(
      contacts_.begin(), contacts_.end(), std::pair(node, body), [](const Contact& c, auto key) {
        return c.node != key.first ? c.node < key.first : c.body < key.second;
      });
  return found != contacts_.end() && found->node == node && found->body == body;
}

void ExplicitContact::add(Contact contact) {
  const auto place = std::upper_bound(contacts_.begin(), contacts_.end(), contact,
                                      [](const Contact& a, const Contact& b) {
                                        return a.node != b.node ? a.node < b.node : a.body < b.body;
                                      });
  contacts_.insert(place, std::move(contact));
}

// The box around a node within which it touches no body that is not watched anyway. Where bodies
// move, node and surface share the gap.
void ExplicitContact::guard(Index node) {
  double gap = kInfinity;
  if (!(*nodes_.held)[node]) {
    for (std::size_t b = 0; b < free_.size(); ++b) {
      const Index body = static_cast<Index>(b);
      if (!active(node, body)) gap = std::min(gap, std::max(0.0, lower_gap(node, body)));
    }
  }
  const double share = any_free_ ? 0.5 : 1.0;
  until_[node] = any_free_ ? drift_ + 0.5 * gap : kInfinity;
  const double limit = share * gap / std::sqrt(3.0);
  nodes_.layout->write(limit_.data(), node, Vec3::Constant(limit));
  nodes_.layout->write(origin_.data(), node, nodes_.layout->read(nodes_.x, node));
}

void ExplicitContact::guard_all() {
  for (std::size_t i = 0; i < radius_.size(); ++i) guard(static_cast<Index>(i));
  earliest_ = *std::min_element(until_.begin(), until_.end());
}

// A point in the axes in which contacts are kept: the body's, or the world's where it is fixed.
Vec3 ExplicitContact::inward(Index body, const BodyState& pose, const Vec3& x) const {
  return (*bodies_)[body].fixed ? x : to_body(pose, x);
}

Vec3 ExplicitContact::world_normal(const Contact& c) const {
  return (*bodies_)[c.body].fixed ? c.normal : Vec3(poses_[c.body].attitude * c.normal);
}

void ExplicitContact::query(Contact& c, const Vec3& at) const {
  const Body& body = (*bodies_)[c.body];
  const BodyState& pose = poses_[c.body];
  const SurfacePoint p = body.shape->nearest(body.fixed ? to_body(pose, at) : at);
  c.origin = at;
  c.normal = body.fixed ? Vec3(pose.attitude * p.normal) : p.normal;
  c.distance = p.distance;
}

// Follows a straight path in body axes, advancing by the distance to the surface. True with the
// query where it comes nearer than the radius.
bool ExplicitContact::enters(Index node, Index body, const Vec3& from, const Vec3& to,
                             Contact& contact) const {
  const double r = radius_[node];
  const double length = (to - from).norm();
  double t = 0.0;
  for (int k = 0; k < kMostPathSteps; ++k) {
    contact.node = node;
    contact.body = body;
    query(contact, from + t * (to - from));
    const double gap = contact.distance - r;
    if (gap <= (t < 1.0 ? 1e-3 * r : 0.0)) return true;
    if (t >= 1.0) return false;
    t = std::min(1.0, t + gap / std::max(length, 1e-300));
  }
  return contact.distance < r;
}

void ExplicitContact::look_for_entries() {
  const SweepLayout& layout = *nodes_.layout;
  const auto look = [&](Index node) {
    const Vec3 x = layout.read(nodes_.x, node);
    const Vec3 old = x - h_ * layout.read(nodes_.v, node);
    for (std::size_t b = 0; b < free_.size(); ++b) {
      const Index body = static_cast<Index>(b);
      if (active(node, body) || lower_gap(node, body) > (x - old).norm() + kFar * radius_[node])
        continue;
      Contact c;
      const Vec3 from = inward(body, old_poses_[b], old), to = inward(body, poses_[b], x);
      if (!enters(node, body, from, to, c) && c.distance > (1.0 + kNear) * radius_[node]) continue;
      c.place = c.anchor = from;
      add(c);
    }
    guard(node);
  };
  const long count = kernels::sweeps().outside(nodes_.x, origin_.data(), limit_.data(),
                                               layout.size(), found_.data());
  for (long k = 0; k < count; ++k) {
    for (long at = 8L * found_[k]; at < 8L * found_[k] + 8; ++at) {
      const auto d = static_cast<std::size_t>(at);
      if (!(std::abs(nodes_.x[d] - origin_[d]) <= limit_[d])) look(layout.node_at(at));
    }
  }
  if (drift_ < earliest_) return;
  for (std::size_t i = 0; i < until_.size(); ++i)
    if (until_[i] <= drift_) look(static_cast<Index>(i));
  earliest_ = *std::min_element(until_.begin(), until_.end());
}

// A new query where the old one no longer serves. A node that seems to have come to another side
// is followed on its way there.
void ExplicitContact::look_again(Contact& c, const Vec3& at) const {
  const double reach = kPlaneReach * radius_[c.node];
  if ((at - c.origin).squaredNorm() <= reach * reach) return;
  const Vec3 normal = c.normal;
  const double plane_gap = c.distance + normal.dot(at - c.origin) - radius_[c.node];
  query(c, at);
  if (plane_gap >= 0.0 || c.normal.dot(normal) >= kSameSide) return;
  Contact hit;
  if (enters(c.node, c.body, c.place, at, hit)) {
    c.origin = hit.origin;
    c.normal = hit.normal;
    c.distance = hit.distance;
  }
}

double ExplicitContact::inverse_mass(const Contact& c, const Vec3& lever,
                                     const Vec3& direction) const {
  const Free& f = free_[c.body];
  const double node = 1.0 / (*nodes_.mass)[c.node];
  if (f.inverse_mass == 0.0) return node;
  const Vec3 arm = lever.cross(direction);
  return node + f.inverse_mass + arm.dot(f.inverse_inertia * arm);
}

Vec3 ExplicitContact::relative_velocity(const Contact& c) const {
  const Vec3 v = nodes_.layout->read(nodes_.v, c.node);
  if (free_[c.body].inverse_mass == 0.0) return v;
  const BodyState& pose = poses_[c.body];
  const Vec3 lever = nodes_.layout->read(nodes_.x, c.node) - pose.position;
  return v - pose.velocity - free_[c.body].spin.cross(lever);
}

// An impulse on the node and its opposite on the body; `moves`: over the sub-step's way too.
void ExplicitContact::push(Contact& c, const Vec3& impulse, bool moves) {
  const SweepLayout& layout = *nodes_.layout;
  c.impulse += impulse;
  const Vec3 x = layout.read(nodes_.x, c.node);
  const Vec3 dv = impulse / (*nodes_.mass)[c.node];
  layout.write(nodes_.v, c.node, layout.read(nodes_.v, c.node) + dv);
  if (moves) layout.write(nodes_.x, c.node, x + h_ * dv);
  Free& f = free_[c.body];
  if (f.inverse_mass == 0.0) return;
  f.touched = true;
  BodyState& pose = poses_[c.body];
  const Vec3 moment = -(x - pose.position).cross(impulse);
  const Vec3 turn = f.inverse_inertia * moment;
  pose.velocity -= f.inverse_mass * impulse;
  pose.angular_momentum += moment;
  f.spin += turn;
  if (!moves) return;
  pose.position -= h_ * f.inverse_mass * impulse;
  pose.attitude = (rotation(h_ * turn) * pose.attitude).normalized();
}

void ExplicitContact::book(const Contact& c, const Vec3& normal, const Vec3& impulse,
                           const Vec3& before, Account& account) const {
  const Vec3 mean = 0.5 * (before + relative_velocity(c));
  const Vec3 along = normal * normal.dot(impulse);
  account.impact_loss -= along.dot(mean);
  account.friction_loss -= (impulse - along).dot(mean);
  if (!(*bodies_)[c.body].fixed) return;
  account.outside_impulse += impulse;
  account.outside_angular_impulse += nodes_.layout->read(nodes_.x, c.node).cross(impulse);
}

// One contact's turn: impulses so that its normal lack and its slip (m over the sub-step; m/s where
// only velocities count) vanish, within what its sums may be: the normal one pushes, friction is
// bounded. Returns the size of the change, N s.
double ExplicitContact::solve(Contact& c, const Vec3& normal, double lack, bool moves) {
  const SweepLayout& layout = *nodes_.layout;
  const double time = moves ? h_ : 1.0;
  Vec3 lever = layout.read(nodes_.x, c.node) - poses_[c.body].position;
  const double size = std::max(-c.push, lack / time / inverse_mass(c, lever, normal));
  if (size != 0.0) push(c, size * normal, moves);
  c.push += size;
  if (friction_ == 0.0 || c.push <= 0.0) return std::abs(size);
  const Vec3 x = layout.read(nodes_.x, c.node);
  Vec3 slip = relative_velocity(c);
  if (moves) {
    const Vec3 anchor = (*bodies_)[c.body].fixed ? c.anchor : to_world(poses_[c.body], c.anchor);
    slip = x - anchor;
  }
  slip -= normal * normal.dot(slip);
  const double way = slip.norm();
  if (way == 0.0) return std::abs(size);
  lever = x - poses_[c.body].position;
  Vec3 wanted = c.drag - slip / (time * inverse_mass(c, lever, slip / way));
  const double limit = friction_ * c.push, most = wanted.norm();
  c.sticks = most <= limit;
  if (!c.sticks) wanted *= limit / most;
  const Vec3 change = wanted - c.drag;
  push(c, change, moves);
  c.drag = wanted;
  return std::abs(size) + change.norm();
}

double ExplicitContact::gap_at(const Contact& c, const Vec3& at) const {
  return c.distance + c.normal.dot(at - c.origin) - radius_[c.node];
}

// All contacts in turn, again and again where bodies carry what one does to another.
void ExplicitContact::solve_all(bool moves) {
  const bool coupled = any_free_ || bodies_->size() > 1;
  for (int k = 0; k < (coupled ? kMostTurns : 1); ++k) {
    double change = 0.0, largest = 0.0;
    for (Contact& c : contacts_) {
      const Vec3 normal = world_normal(c);
      double lack = -normal.dot(relative_velocity(c));
      if (moves) {
        const Vec3 x = nodes_.layout->read(nodes_.x, c.node);
        lack = std::min(0.0, c.gap) - gap_at(c, inward(c.body, poses_[c.body], x));
      } else if (!c.pushed) {
        continue;
      }
      if (lack <= 0.0 && c.push == 0.0) continue;
      change = std::max(change, solve(c, normal, lack, moves));
      largest = std::max(largest, c.push);
    }
    if (change <= kTurnTolerance * largest) break;
  }
}

// Looks at the surface again where that is due, and forgets the impulses of the last sub-step.
void ExplicitContact::meet(Contact& c) {
  look_again(c, inward(c.body, poses_[c.body], nodes_.layout->read(nodes_.x, c.node)));
  if (c.fresh) c.relative = relative_velocity(c);
  c.push = 0.0;
  c.drag = Vec3::Zero();
  c.sticks = friction_ > 0.0;
}

// Books what a contact gave, and keeps what the next sub-step needs.
void ExplicitContact::leave(Contact& c, Account& account, Given& given) {
  const SweepLayout& layout = *nodes_.layout;
  c.pushed = c.push > 0.0;
  if (c.pushed) {
    const Vec3 normal = world_normal(c);
    const Vec3 impulse = c.push * normal + c.drag;
    given.impulse += impulse;
    book(c, normal, impulse, c.relative, account);
  } else {
    c.sticks = false;
  }
  Vec3 x = layout.read(nodes_.x, c.node);
  Vec3 at = inward(c.body, poses_[c.body], x);
  c.gap = gap_at(c, at);
  if (c.gap < 0.0) {  // depth is undone without velocity, lest it become energy
    const Vec3 shift = std::min(-c.gap, kMostShift * radius_[c.node]) * world_normal(c);
    x += shift;
    layout.write(nodes_.x, c.node, x);
    given.shift += (*nodes_.mass)[c.node] * shift;
    at = inward(c.body, poses_[c.body], x);
    c.gap = gap_at(c, at);
  }
  c.place = at;
  if (!c.sticks) c.anchor = at;
  c.relative = relative_velocity(c);
  c.fresh = false;
}

// Nodes that have left are guarded by their boxes again.
void ExplicitContact::drop_far() {
  const auto far = [&](const Contact& c) {
    return c.gap > kFar * radius_[c.node] && c.impulse.isZero(0.0);
  };
  if (std::none_of(contacts_.begin(), contacts_.end(), far)) return;
  for (std::size_t k = 0; k < contacts_.size();) {
    if (!far(contacts_[k])) {
      ++k;
      continue;
    }
    const Index node = contacts_[k].node;
    contacts_.erase(contacts_.begin() + static_cast<std::ptrdiff_t>(k));
    guard(node);
    earliest_ = std::min(earliest_, until_[node]);
  }
}

ExplicitContact::Given ExplicitContact::step(const Vec3& gravity, double kick, Account& account) {
  Given given;
  move_bodies(gravity, kick);
  look_for_entries();
  for (Contact& c : contacts_) meet(c);
  solve_all(true);
  for (Contact& c : contacts_) leave(c, account, given);
  for (std::size_t b = 0; b < free_.size(); ++b)
    if (free_[b].touched) refresh(static_cast<Index>(b));
  drop_far();
  return given;
}

void ExplicitContact::finish(const Vec3& gravity, double kick, Account& account) {
  for (std::size_t b = 0; b < free_.size(); ++b)
    if (!(*bodies_)[b].fixed) poses_[b].velocity += kick * gravity;
  for (Contact& c : contacts_) {
    c.push = 0.0;
    c.drag = Vec3::Zero();
  }
  solve_all(false);
  for (Contact& c : contacts_) {
    const Vec3 normal = world_normal(c);
    if (c.push > 0.0) book(c, normal, c.push * normal + c.drag, c.relative, account);
  }
}

void ExplicitContact::end(double h, std::vector<BodyState>& bodies,
                          std::vector<Touch>& touches) const {
  for (std::size_t b = 0; b < free_.size(); ++b)
    if (free_[b].touched) bodies[b] = poses_[b];
  touches.clear();
  for (const Contact& c : contacts_) {
    if (c.impulse.isZero(0.0) || c.gap > kFar * radius_[c.node]) continue;
    touches.push_back({c.node, c.body, c.sticks, c.impulse / h});
  }
}

}  // namespace retiarius

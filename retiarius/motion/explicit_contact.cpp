#include "retiarius/motion/explicit_contact.hpp"

#include <algorithm>

#include <Eigen/LU>

#include "retiarius/bodies/free_rotation.hpp"

namespace retiarius {

namespace {

// Depth undone in one sub-step, as a share of the thread's radius.
constexpr double kMostShift = 0.1;

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
  laid_out_ = false;
  contacts_.reserve(radius_.size() * bodies_->size());
  drift_ = way_ = 0.0;
  due_ = kInfinity;
  unsettled_ = 0;
  any_far_ = true;
  for (std::size_t i = 0; i < radius_.size(); ++i) {
    const Index node = static_cast<Index>(i);
    if ((*nodes_.held)[i]) continue;
    for (std::size_t b = 0; b < free_.size(); ++b) {
      const Index body = static_cast<Index>(b);
      if (lower_gap(node, body) > kNear * radius_[i]) continue;
      Contact c = watched(node, body);
      query(c, inward(body, poses_[b], nodes_.layout->read(nodes_.x, node)));
      c.place = c.anchor = c.origin;
      c.gap = c.distance - radius_[i];
      if (c.gap > kNear * radius_[i]) continue;
      c.relative = relative_velocity(c);
      contacts_.push_back(c);
    }
  }
  for (const Touch& t : start.touches) {
    const auto c = find(t.node, t.body);
    if (c != contacts_.cend())
      contacts_[static_cast<std::size_t>(c - contacts_.cbegin())].sticks = t.sticks;
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

// A point in the axes in which contacts are kept: the body's, or the world's where it is fixed.
Vec3 ExplicitContact::inward(Index body, const BodyState& pose, const Vec3& x) const {
  return (*bodies_)[body].fixed ? x : to_body(pose, x);
}

Vec3 ExplicitContact::world_normal(const Contact& c) const {
  return (*bodies_)[c.body].fixed ? c.normal : Vec3(poses_[c.body].attitude * c.normal);
}

void ExplicitContact::book(const Contact& c, Account& account) const {
  const Vec3 mean = 0.5 * (c.relative + relative_velocity(c));
  const Vec3 along = c.push * c.up, impulse = along + c.drag;
  account.impact_loss -= along.dot(mean);
  account.friction_loss -= c.drag.dot(mean);
  if (!(*bodies_)[c.body].fixed) return;
  account.outside_impulse += impulse;
  account.outside_angular_impulse += nodes_.layout->read(nodes_.x, c.node).cross(impulse);
}

// Looks at the surface again where that is due, and forgets the impulses of the last sub-step.
void ExplicitContact::meet(Contact& c) {
  look_again(c, inward(c.body, poses_[c.body], nodes_.layout->read(nodes_.x, c.node)));
  aim(c);
  c.sticks = friction_ > 0.0;
}

// Where impulses act from now on; there are none yet.
void ExplicitContact::aim(Contact& c) {
  c.up = world_normal(c);
  c.lever = nodes_.layout->read(nodes_.x, c.node) - poses_[c.body].position;
  c.push = 0.0;
  c.drag = Vec3::Zero();
}

// Books what a contact gave, and keeps what the next sub-step needs.
void ExplicitContact::leave(Contact& c, Account& account, Given& given) {
  c.pushed = c.push > 0.0;
  if (c.pushed) {
    given.impulse += c.push * c.up + c.drag;
    book(c, account);
  } else {
    c.sticks = false;
  }
  lift(c, nodes_.layout->read(nodes_.x, c.node), given);
  any_far_ |= c.gap > kFar * c.radius;
  if (!c.sticks) c.anchor = c.place;
  c.relative = relative_velocity(c);
}

// Notes where a node has come to, and takes it out of the body.
void ExplicitContact::lift(Contact& c, Vec3 x, Given& given) {
  Vec3 at = inward(c.body, poses_[c.body], x);
  c.gap = gap_at(c, at);
  if (c.gap < 0.0) {  // depth is undone without velocity, lest it become energy
    const Vec3 shift = std::min(-c.gap, kMostShift * radius_[c.node]) * world_normal(c);
    x += shift;
    nodes_.layout->write(nodes_.x, c.node, x);
    given.shift += (*nodes_.mass)[c.node] * shift;
    at = inward(c.body, poses_[c.body], x);
    c.gap = gap_at(c, at);
  }
  c.place = at;
}

ExplicitContact::Given ExplicitContact::step(const Vec3& gravity, double kick, double way,
                                             Account& account) {
  Given given;
  way_ += way;
  move_bodies(gravity, kick);
  look_for_entries();
  if (alone()) {
    settle_alone(account, given);
  } else {
    for (Contact& c : contacts_) meet(c);
    solve_all(true);
    for (Contact& c : contacts_) leave(c, account, given);
  }
  for (std::size_t b = 0; b < free_.size(); ++b)
    if (free_[b].touched) refresh(static_cast<Index>(b));
  drop_far();
  return given;
}

void ExplicitContact::finish(const Vec3& gravity, double kick, Account& account) {
  take_back();
  for (std::size_t b = 0; b < free_.size(); ++b)
    if (!(*bodies_)[b].fixed) poses_[b].velocity += kick * gravity;
  for (Contact& c : contacts_) aim(c);
  solve_all(false);
  for (const Contact& c : contacts_)
    if (c.push > 0.0) book(c, account);
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

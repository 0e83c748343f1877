// Impulses of the contacts of one sub-step, with all that bodies carry from one to another.
#include <algorithm>
#include <cmath>

#include "retiarius/bodies/free_rotation.hpp"
#include "retiarius/motion/explicit_contact.hpp"

namespace retiarius {

namespace {

// Contacts take turns until none changes by more than this share of the largest impulse, or more
// than rounding of places and velocities (a few digits of the last place) makes of it. With k nodes
// of mass m on a body of mass M an error falls to about (m / (m + M))^2 of itself in a turn. Where
// the turns are not enough, the pairs of impulses are still equal and opposite, the sub-steps after
// this go on from there, and the run is told.
constexpr int kMostTurns = 2000;
constexpr double kTurnTolerance = 1e-10;
constexpr double kRounding = 4e-15;
// Below this gap, as a share of the radius, a contact is closed: of nodes that meet a body together
// all are stopped with it, although rounding decides which one is still pushed.
constexpr double kClosed = 1e-6;

}  // namespace

double ExplicitContact::gap_at(const Contact& c, const Vec3& at) const {
  return c.distance + c.normal.dot(at - c.origin) - c.radius;
}

Vec3 ExplicitContact::relative_velocity(const Contact& c) const {
  const Vec3 v = nodes_.layout->read(nodes_.v, c.node);
  if (free_[c.body].inverse_mass == 0.0) return v;
  const BodyState& pose = poses_[c.body];
  const Vec3 lever = nodes_.layout->read(nodes_.x, c.node) - pose.position;
  return v - pose.velocity - free_[c.body].spin.cross(lever);
}

double ExplicitContact::inverse_mass(const Contact& c, const Vec3& direction) const {
  const Free& f = free_[c.body];
  const double node = 1.0 / (*nodes_.mass)[c.node];
  if (f.inverse_mass == 0.0) return node;
  const Vec3 arm = c.lever.cross(direction);
  return node + f.inverse_mass + arm.dot(f.inverse_inertia * arm);
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
  const Vec3 moment = -c.lever.cross(impulse);
  const Vec3 turn = f.inverse_inertia * moment;
  pose.velocity -= f.inverse_mass * impulse;
  pose.angular_momentum += moment;
  f.spin += turn;
  if (!moves) return;
  pose.position -= h_ * f.inverse_mass * impulse;
  pose.attitude = (rotation(h_ * turn) * pose.attitude).normalized();
}

// One contact's turn: impulses so that its normal lack and its slip (m over the sub-step; m/s where
// only velocities count) vanish, within what its sums may be: the normal one pushes, friction is
// bounded. Returns the size of the change, N s.
double ExplicitContact::solve(Contact& c, double lack, bool moves) {
  const SweepLayout& layout = *nodes_.layout;
  const double time = moves ? h_ : 1.0;
  const Vec3& normal = c.up;
  const double size = std::max(-c.push, lack / time / inverse_mass(c, normal));
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
  Vec3 wanted = c.drag - slip / (time * inverse_mass(c, slip / way));
  const double limit = friction_ * c.push, most = wanted.norm();
  c.sticks = most <= limit;
  if (!c.sticks) wanted *= limit / most;
  const Vec3 change = wanted - c.drag;
  push(c, change, moves);
  c.drag = wanted;
  return std::abs(size) + change.norm();
}

// The impulse, N s, that rounding alone may ask of a contact.
double ExplicitContact::rounding(const Contact& c, bool moves) const {
  const double* what = moves ? nodes_.x : nodes_.v;
  const double size = nodes_.layout->read(what, c.node).norm();
  return kRounding * (*nodes_.mass)[c.node] * (moves ? size / h_ : size);
}

// All contacts in turn, again and again where bodies carry what one does to another.
void ExplicitContact::solve_all(bool moves) {
  const bool coupled = any_free_ || bodies_->size() > 1;
  for (int k = 0; k < (coupled ? kMostTurns : 1); ++k) {
    double change = 0.0, largest = 0.0;
    for (Contact& c : contacts_) {
      double lack = -c.up.dot(relative_velocity(c));
      if (moves) {
        const Vec3 x = nodes_.layout->read(nodes_.x, c.node);
        lack = std::min(0.0, c.gap) - gap_at(c, inward(c.body, poses_[c.body], x));
      } else if (!c.pushed && c.gap > kClosed * radius_[c.node]) {
        continue;
      }
      if (lack <= 0.0 && c.push == 0.0) continue;
      change = std::max(change, solve(c, lack, moves) - rounding(c, moves));
      largest = std::max(largest, c.push);
    }
    if (!coupled || change <= kTurnTolerance * largest) return;
  }
  ++unsettled_;
}

}  // namespace retiarius

// Contacts with one fixed body: none knows of another, so each is settled in one visit.
#include <algorithm>

#include "retiarius/motion/explicit_contact.hpp"

namespace retiarius {

namespace {

Vec3 read(const double* array, const SweepLayout::Slot& s) {
  const double* const p = array + s.offset;
  return {p[0], p[s.stride], p[2 * s.stride]};
}

void write(double* array, const SweepLayout::Slot& s, const Vec3& value) {
  double* const p = array + s.offset;
  p[0] = value.x();
  p[s.stride] = value.y();
  p[2 * s.stride] = value.z();
}

}  // namespace

// No contact changes what another one meets: no body moves, and a node touches no second one.
bool ExplicitContact::alone() const { return !any_free_ && bodies_->size() == 1; }

// meet(), one turn of solve() and leave() with the node's place and velocity kept at hand. A node
// that stays clear of the surface, as many that are watched do, leaves at once.
void ExplicitContact::settle_alone(Contact& c, Account& account, Given& given) {
  Vec3 x = read(nodes_.x, c.slot);
  Vec3 v = read(nodes_.v, c.slot);
  if ((x - c.origin).squaredNorm() > c.reach) look_again(c, x);
  const double gap = c.distance + c.normal.dot(x - c.origin) - c.radius;
  const double lack = std::min(0.0, c.gap) - gap;
  if (c.pushed) {
    c.push = 0.0;
    c.drag = Vec3::Zero();
  }
  c.pushed = lack > 0.0;
  c.sticks = false;
  if (c.fresh) c.relative = v;
  c.fresh = false;
  c.gap = gap;
  if (c.pushed) {
    c.up = c.normal;
    stop_alone(c, lack, x, v);
    write(nodes_.v, c.slot, v);
    write(nodes_.x, c.slot, x);
    given.impulse += c.push * c.up + c.drag;
    book_alone(c, x, v, account);
    c.gap = c.distance + c.normal.dot(x - c.origin) - c.radius;
  }
  if (c.gap >= 0.0) {
    c.place = x;
    any_far_ |= c.gap > kFar * c.radius;
  } else {
    lift(c, x, given);
  }
  if (!c.sticks) c.anchor = c.place;
  c.relative = v;
}

// The normal impulse that makes up for the lack, and friction towards the anchor within its limit.
void ExplicitContact::stop_alone(Contact& c, double lack, Vec3& x, Vec3& v) const {
  const double per_time = 1.0 / h_;
  c.push = c.mass * (per_time * lack);
  v += (per_time * lack) * c.up;
  x += lack * c.up;
  c.sticks = friction_ > 0.0;
  if (c.sticks) {
    Vec3 back = c.anchor - x;
    back -= c.up.dot(back) * c.up;
    const double way = back.norm(), most = friction_ * lack;
    c.sticks = way <= most;
    if (!c.sticks) back *= most / way;
    x += back;
    v += per_time * back;
    c.drag = (c.mass * per_time) * back;
  }
  c.impulse += c.push * c.up + c.drag;
}

void ExplicitContact::book_alone(const Contact& c, const Vec3& x, const Vec3& v, Account& account) {
  const Vec3 mean = 0.5 * (c.relative + v);
  const Vec3 along = c.push * c.up, impulse = along + c.drag;
  account.impact_loss -= along.dot(mean);
  account.friction_loss -= c.drag.dot(mean);
  account.outside_impulse += impulse;
  account.outside_angular_impulse += x.cross(impulse);
}

}  // namespace retiarius

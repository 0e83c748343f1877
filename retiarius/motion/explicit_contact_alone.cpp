// Contacts with one fixed body: none knows of another, so each is settled in one visit.
#include <algorithm>

#include "retiarius/motion/explicit_contact.hpp"

namespace retiarius {

// No contact changes what another one meets: no body moves, and a node touches no second one.
bool ExplicitContact::alone() const { return !any_free_ && bodies_->size() == 1; }

// meet(), one turn of solve() and leave() with the node's place and velocity kept at hand. A node
// that stays clear of the surface, as most that are watched do, leaves at once.
void ExplicitContact::settle_alone(Contact& c, Account& account, Given& given) {
  const SweepLayout& layout = *nodes_.layout;
  Vec3 x = layout.read(nodes_.x, c.node);
  Vec3 v = layout.read(nodes_.v, c.node);
  look_again(c, x);
  const double gap = gap_at(c, x);
  const double lack = std::min(0.0, c.gap) - gap;
  c.push = 0.0;
  c.drag = Vec3::Zero();
  c.pushed = lack > 0.0;
  c.sticks = false;
  if (lack <= 0.0 && gap >= 0.0) {
    c.gap = gap;
    c.place = c.anchor = x;
    c.relative = v;
    c.fresh = false;
    return;
  }
  if (c.fresh) c.relative = v;
  c.up = c.normal;
  c.lever = x - poses_[c.body].position;
  if (c.pushed) {
    stop_alone(c, lack, x, v);
    layout.write(nodes_.v, c.node, v);
    layout.write(nodes_.x, c.node, x);
    given.impulse += c.push * c.up + c.drag;
    book(c, account);
  }
  lift(c, x, given);
  if (!c.sticks) c.anchor = c.place;
  c.relative = v;
  c.fresh = false;
}

// The normal impulse that makes up for the lack, and friction towards the anchor within its limit.
void ExplicitContact::stop_alone(Contact& c, double lack, Vec3& x, Vec3& v) const {
  const double mass = (*nodes_.mass)[c.node], per_time = 1.0 / h_;
  c.push = mass * (per_time * lack);
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
    c.drag = (mass * per_time) * back;
  }
  c.impulse += c.push * c.up + c.drag;
}

}  // namespace retiarius

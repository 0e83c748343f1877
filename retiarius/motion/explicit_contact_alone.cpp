// Contacts with one fixed body: none knows of another, so each is settled in one visit. Nodes that
// stay clear of the surface, as most that are watched do, are seen to eight at a time.
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

double ExplicitContact::gap_of(std::size_t k) const {
  return laid_out_ ? planes_.gap(k) : contacts_[k].gap;
}

// Lays the contacts out for the kernel.
void ExplicitContact::lay_out() {
  if (laid_out_) return;
  laid_out_ = true;
  slots_.clear();
  for (const Contact& c : contacts_) slots_.push_back(c.slot);
  planes_.lay_out(slots_, nodes_.layout->size());
  pushed_.clear();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Contact& c = contacts_[k];
    planes_.set_plane(k, {c.origin, c.normal, c.distance - c.radius, c.reach});
    planes_.set_far(k, c.impulse.isZero(0.0) ? kFar * c.radius : kInfinity);
    planes_.set_motion(k, c.gap, c.relative);
    if (c.pushed) pushed_.push_back(k);
  }
}

// Before contacts come or go, or are looked at otherwise.
void ExplicitContact::take_back() {
  if (!laid_out_) return;
  laid_out_ = false;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    contacts_[k].gap = planes_.gap(k);
    contacts_[k].relative = planes_.velocity(k);
  }
}

void ExplicitContact::settle_alone(Account& account, Given& given) {
  lay_out();
  for (const std::size_t k : pushed_) contacts_[k].pushed = false;
  const std::vector<int>& touched = planes_.touched(nodes_.x, nodes_.v, any_far_);
  for (const int k : touched) settle_alone(static_cast<std::size_t>(k), account, given);
  for (const std::size_t k : pushed_) contacts_[k].sticks &= contacts_[k].pushed;
  pushed_.clear();
  for (const int k : touched)
    if (contacts_[k].pushed) pushed_.push_back(static_cast<std::size_t>(k));
}

// meet(), one turn of solve() and leave() with the node's place and velocity kept at hand.
void ExplicitContact::settle_alone(std::size_t k, Account& account, Given& given) {
  Contact& c = contacts_[k];
  Vec3 x = read(nodes_.x, c.slot);
  Vec3 v = read(nodes_.v, c.slot);
  c.relative = planes_.velocity(k);
  c.place = x - h_ * v;
  if (!c.sticks) c.anchor = c.place;
  if ((x - c.origin).squaredNorm() > c.reach) {
    look_again(c, x);
    planes_.set_plane(k, {c.origin, c.normal, c.distance - c.radius, c.reach});
  }
  const double depth = std::min(0.0, planes_.gap(k));
  c.gap = gap_at(c, x);
  const double lack = depth - c.gap;
  c.pushed = lack > 0.0;
  c.sticks = false;
  if (c.pushed) {
    c.up = c.normal;
    stop_alone(c, lack, x, v);
    write(nodes_.v, c.slot, v);
    write(nodes_.x, c.slot, x);
    given.impulse += c.push * c.up + c.drag;
    book_alone(c, x, v, account);
    planes_.set_far(k, kInfinity);
    c.gap = depth;
  }
  if (c.gap < 0.0) lift(c, x, given);
  any_far_ |= c.gap > kFar * c.radius;
  planes_.set_motion(k, c.gap, v);
}

// The normal impulse that makes up for the lack, and friction towards the anchor within its limit.
void ExplicitContact::stop_alone(Contact& c, double lack, Vec3& x, Vec3& v) const {
  const double per_time = 1.0 / h_;
  c.push = c.mass * (per_time * lack);
  c.drag = Vec3::Zero();
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

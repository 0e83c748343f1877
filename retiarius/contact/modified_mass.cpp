#include "retiarius/contact/modified_mass.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {

namespace {

// A node enters contact when it is this share of its radius deeper than touching; released nodes
// float at zero and must not be caught again by round-off.
constexpr double kEntryDepth = 1e-3;
// Sliding friction is iterated with the normal reaction until it holds to this share.
constexpr double kFrictionTolerance = 1e-3;
// Slips slower than this, m/s, are rest: below it friction is proportionately less in the step,
// and the node sticks from the next one on.
constexpr double kSlowSlip = 1e-2;
// Cosine between the normals where a node enters and where it was heading, on one side of a body.
constexpr double kSameSide = 0.5;
constexpr int kMostRevisions = 12;
// A node that leaves and enters again and again within a step stays at last.
constexpr int kMostReleases = 2;
constexpr int kMostPathSteps = 400;

bool near_body(const Body& body, const BodyState& s, const Vec3& a, const Vec3& b, double margin) {
  const double reach = body.shape->bounding_radius() + margin;
  if (!std::isfinite(reach)) return true;
  const Vec3 d = b - a;
  const double length2 = d.squaredNorm();
  double t = length2 > 0.0 ? (s.position - a).dot(d) / length2 : 0.0;
  t = std::clamp(t, 0.0, 1.0);
  return (a + t * d - s.position).squaredNorm() <= reach * reach;
}

}  // namespace

ModifiedMass::ModifiedMass(const std::vector<Body>& bodies, std::vector<double> radius,
                           std::vector<double> mass, double friction)
    : bodies_(&bodies),
      radius_(std::move(radius)),
      mass_(std::move(mass)),
      friction_(friction),
      contact_of_(radius_.size(), kNone),
      released_(radius_.size(), 0) {}

// The contact of a node that would be at `target_in_body` (body axes) at the step's end.
ModifiedMass::Contact ModifiedMass::make_contact(Index node, Index body, const Vec3& target_in_body,
                                                 bool sticks) const {
  const SurfacePoint p = (*bodies_)[body].shape->nearest(target_in_body);
  const BodyState& pose = predicted_[body];
  Contact c;
  c.node = node;
  c.body = body;
  c.normal = pose.attitude * p.normal;
  c.target = to_world(pose, target_in_body + (radius_[node] - p.distance) * p.normal);
  c.lever = c.target - pose.position;
  c.sticks = sticks && friction_ > 0.0;
  return c;
}

void ModifiedMass::begin(const Step& step, const std::vector<Vec3>& predicted,
                         const std::vector<BodyState>& bodies, const std::vector<bool>& held) {
  const State& start = *step.start;
  step_ = &step;
  start_ = &start;
  predicted_ = bodies;
  now_ = bodies;
  held_ = held;
  revisions_ = 0;
  contacts_.clear();
  std::fill(contact_of_.begin(), contact_of_.end(), kNone);
  std::fill(released_.begin(), released_.end(), 0);
  for (const Touch& t : start.touches) {
    if (held_[t.node]) continue;
    const Vec3 where = t.sticks ? to_body(start.bodies[t.body], start.x[t.node])
                                : to_body(bodies[t.body], predicted[t.node]);
    contacts_.push_back(make_contact(t.node, t.body, where, t.sticks));
    contact_of_[t.node] = static_cast<Index>(contacts_.size()) - 1;
    if (!t.sticks)
      contacts_.back().limit = friction_ * std::max(0.0, t.reaction.dot(contacts_.back().normal));
  }
  find_entries(predicted, bodies);
  rebuild();
}

// Follows the straight path of a node relative to the body, advancing by the distance to the
// surface, until it touches. True with the place of entry in body axes.
bool ModifiedMass::entry(Index node, Index body, const Vec3& x1, const BodyState& end,
                         Vec3& hit) const {
  const Shape& shape = *(*bodies_)[body].shape;
  const Vec3 from = to_body(start_->bodies[body], start_->x[node]);
  const Vec3 to = to_body(end, x1);
  const double depth = (released_[node] ? 10.0 : 1.0) * kEntryDepth * radius_[node];
  const double length = (to - from).norm();
  double t = 0.0;
  for (int k = 0; k < kMostPathSteps; ++k) {
    const Vec3 p = from + t * (to - from);
    const double gap = shape.nearest(p).distance - radius_[node];
    if (gap < -depth) {
      hit = p;
      return true;
    }
    if (t >= 1.0) return false;
    t = std::min(1.0, t + std::max(gap, 0.05 * radius_[node]) / std::max(length, 1e-300));
  }
  hit = to;
  return shape.nearest(to).distance < radius_[node] - depth;
}

bool ModifiedMass::find_entries(const std::vector<Vec3>& x1, const std::vector<BodyState>& bodies) {
  bool found = false;
  for (std::size_t b = 0; b < bodies_->size(); ++b) {
    const Index body = static_cast<Index>(b);
    for (std::size_t i = 0; i < radius_.size(); ++i) {
      const Index node = static_cast<Index>(i);
      if (held_[i] || contact_of_[i] != kNone) continue;
      const double drift = (bodies[b].position - start_->bodies[b].position).norm();
      if (!near_body((*bodies_)[b], bodies[b], start_->x[i], x1[i], radius_[i] + drift)) continue;
      Vec3 hit;
      if (!entry(node, body, x1[i], bodies[b], hit)) continue;
      // Without friction the node goes on along the surface to where it was heading, unless that
      // lies nearer to another side than to the one that it enters by.
      const Vec3 end = to_body(bodies[b], x1[i]);
      const Shape& shape = *(*bodies_)[b].shape;
      const SurfacePoint there = shape.nearest(end);
      const bool through =
          there.distance >= radius_[i] || there.normal.dot(shape.nearest(hit).normal) < kSameSide;
      contacts_.push_back(
          make_contact(node, body, friction_ > 0.0 || through ? hit : end, !released_[i]));
      contact_of_[i] = 0;
      found = true;
    }
  }
  return found;
}

// Where the step would take the node if it stuck to where it started, at a pose of the body.
Vec3 ModifiedMass::carried(const Contact& c, const BodyState& pose) const {
  return to_world(pose, to_body(start_->bodies[c.body], start_->x[c.node]));
}

// The whole impulse of the surface on the node over the step, along the normal: of the reaction,
// and of giving the node the surface's velocity at the end. A node that follows a curved surface
// leaves an implicit Euler step along the chord, so that the second part carries half of the
// centripetal force.
double ModifiedMass::normal_impulse(const Contact& c, const Vec3& x1, const Vec3& reaction) const {
  const Vec3& v0 = start_->v[c.node];
  const Vec3 stage =
      step_->stage_velocity(c.node, start_->x[c.node] + (x1 - start_->x[c.node]) / step_->reach);
  const Vec3 end = v0 + step_->reach * (stage - v0);
  const BodyState& free = predicted_[c.body];
  const Vec3 point = free.position + c.lever;
  const Vec3 pushed = to_world(now_[c.body], to_body(free, point)) - point;
  const Vec3 surface = point_velocity((*bodies_)[c.body], free, point) + step_->rate * pushed;
  return c.normal.dot(step_->reaction_impulse() * reaction + mass_[c.node] * (surface - end));
}

// Coulomb's law for one contact; true if it changed. Within a step a node only goes from sticking
// to sliding; a node that ends a step at rest sticks in the next one. So no contact alternates.
bool ModifiedMass::revise_contact(Contact& c, const Vec3& reaction, bool may_change) const {
  if (friction_ == 0.0 || !may_change) return false;
  const double limit = friction_ * std::max(0.0, reaction.dot(c.normal));
  if (c.sticks) {
    const Vec3 along = reaction - c.normal * c.normal.dot(reaction);
    if (along.norm() <= limit * (1.0 + 1e-9)) return false;
    c.sticks = false;
    c.limit = limit;
    return true;
  }
  if (std::abs(limit - c.limit) <= kFrictionTolerance * std::max(limit, c.limit)) return false;
  c.limit = limit;
  return true;
}

// Whether a sliding node has come to rest on the body.
bool ModifiedMass::at_rest(const Contact& c) const {
  const Vec3 d = end_[c.node] - carried(c, now_[c.body]);
  return (d - c.normal * c.normal.dot(d)).norm() <= kSlowSlip * step_->h;
}

bool ModifiedMass::revise(const std::vector<Vec3>& x1, const std::vector<BodyState>& bodies,
                          const std::vector<Vec3>& reaction, bool) {
  now_ = bodies;
  end_ = x1;
  const bool may_change = ++revisions_ <= kMostRevisions;
  double largest = 0.0;
  for (const Contact& c : contacts_) largest = std::max(largest, reaction[c.node].norm());
  largest *= step_->reaction_impulse();
  bool changed = false;
  std::erase_if(contacts_, [&](Contact& c) {
    const bool pulls = may_change && released_[c.node] < kMostReleases &&
                       normal_impulse(c, x1[c.node], reaction[c.node]) < -1e-9 * largest;
    if (!pulls) return false;
    changed = true;
    // A node that sticks may pull only because it is dragged along: it slides before it leaves.
    if (c.sticks) {
      c.sticks = false;
      c.limit = 0.0;
      return false;
    }
    ++released_[c.node];
    return true;
  });
  for (Contact& c : contacts_) changed |= revise_contact(c, reaction[c.node], may_change);
  std::fill(contact_of_.begin(), contact_of_.end(), kNone);
  for (std::size_t k = 0; k < contacts_.size(); ++k)
    contact_of_[contacts_[k].node] = static_cast<Index>(k);
  changed |= find_entries(x1, bodies);
  if (changed) rebuild();
  return changed;
}

void ModifiedMass::rebuild() {
  std::sort(contacts_.begin(), contacts_.end(),
            [](const Contact& a, const Contact& b) { return a.node < b.node; });
  constraints_.clear();
  std::fill(contact_of_.begin(), contact_of_.end(), kNone);
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Contact& c = contacts_[k];
    contact_of_[c.node] = static_cast<Index>(k);
    Constraint constraint;
    constraint.node = c.node;
    constraint.blocked = c.sticks ? Mat3(Mat3::Identity()) : Mat3(c.normal * c.normal.transpose());
    constraint.target = c.target;
    constraint.body = (*bodies_)[c.body].fixed ? kNone : c.body;
    constraint.lever = c.lever;
    if (!c.sticks && friction_ > 0.0) {
      constraint.limit = c.limit;
      constraint.carried = carried(c, predicted_[c.body]);
      constraint.smoothing = kSlowSlip * step_->h;
    }
    constraints_.push_back(constraint);
  }
}

void ModifiedMass::contacts(std::vector<SolvedContact>& result) const {
  result.clear();
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const Contact& c = contacts_[k];
    const BodyState& free = predicted_[c.body];
    const Vec3 point = to_world(now_[c.body], to_body(free, free.position + c.lever));
    const bool sticks = c.sticks || (friction_ > 0.0 && at_rest(c));
    result.push_back({c.node, c.body, sticks, c.normal, point, constraints_[k].blocked});
  }
}

}  // namespace retiarius

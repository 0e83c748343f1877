#include "retiarius/contact/modified_mass.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {

namespace {

// A node enters contact when it is this share of its radius deeper than touching; released nodes
// float at zero and must not be caught again by round-off.
constexpr double kEntryDepth = 1e-3;
// The slip, m/s, that smooths friction: at it friction is 0.71 of its limit.
constexpr double kSlowSlip = 1e-3;
// A node that slips no faster, m/s, is held at the start of the next step, and slides there if
// friction cannot hold it. At this slip friction is 0.98 of its limit: what it can hold, stops.
constexpr double kRestSlip = 5.0 * kSlowSlip;
// Cosine between the normals where a node enters and where it was heading, on one side of a body.
constexpr double kSameSide = 0.5;
constexpr int kMostRevisions = 12;
// A node that leaves and enters again and again within a step stays at last.
constexpr int kMostReleases = 2;
constexpr int kMostPathSteps = 400;
// How far a path is followed at least at a time, over the radius: so a node may pass a corner by a
// quarter of its radius too deep, but through no wall, which with its radius on both sides is
// thicker.
constexpr double kLeastAdvance = 0.5;
// How well the place of an entry is found along the path, over the radius.
constexpr double kEntryAccuracy = 0.05;

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
                           std::vector<double> mass, const ContactSpec& spec)
    : bodies_(&bodies),
      radius_(std::move(radius)),
      mass_(std::move(mass)),
      friction_(spec.friction),
      friction_tolerance_(spec.friction_tolerance),
      known_(bodies.size() * radius_.size()),
      paths_(known_.size()),
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
  std::fill(paths_.begin(), paths_.end(), Path());
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
// surface, until it touches. True with the place of entry in body axes. A path that is shorter than
// what is known of its distance from the surface need not be followed, nor one that ends nearer to
// the last one than that was clear of the surface.
bool ModifiedMass::entry(Index node, Index body, const Vec3& x1, const BodyState& end, Vec3& hit) {
  const Shape& shape = *(*bodies_)[body].shape;
  const Vec3 from = to_body(start_->bodies[body], start_->x[node]);
  const Vec3 to = to_body(end, x1);
  const double radius = radius_[node];
  const double depth = (released_[node] ? 10.0 : 1.0) * kEntryDepth * radius;
  const double length = (to - from).norm();
  const std::size_t place = static_cast<std::size_t>(body) * radius_.size() + node;
  Known& known = known_[place];
  if (known.distance - (from - known.place).norm() - radius >= length) return false;
  Path& path = paths_[place];
  if (path.clearance >= (to - path.end).norm()) return false;
  path = {to, kInfinity};
  const auto distance_at = [&](double t) { return shape.nearest(from + t * (to - from)).distance; };
  double t = 0.0, t_before = 0.0, gap_before = kInfinity;
  for (int k = 0; k < kMostPathSteps; ++k) {
    const double distance = distance_at(t), gap = distance - radius;
    if (k == 0) known = {from, distance};
    // Between two places the distance falls from both by at most the way.
    const double way = (t - t_before) * length;
    path.clearance = std::min({path.clearance, gap, 0.5 * (gap_before + gap - way)});
    if (gap < -depth) {
      while ((t - t_before) * length > kEntryAccuracy * radius) {
        const double middle = 0.5 * (t_before + t);
        (distance_at(middle) - radius < -depth ? t : t_before) = middle;
      }
      hit = from + t * (to - from);
      return true;
    }
    if (t >= 1.0) return false;
    t_before = t;
    gap_before = gap;
    t = std::min(1.0, t + std::max(gap, kLeastAdvance * radius) / length);
  }
  path.clearance = -kInfinity;
  hit = to;
  return shape.nearest(to).distance < radius - depth;
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
      contacts_.push_back(enter(node, body, hit, to_body(bodies[b], x1[i])));
      contact_of_[i] = 0;
      found = true;
    }
  }
  return found;
}

// The contact of a node that touches at `hit` on its way to `end`, both in body axes. Without
// friction it goes on along the surface to where it was heading, unless that lies nearer to another
// side than to the one that it enters by. With friction it stays where it enters if friction on its
// own impact would stop it; else it slides, at first under that friction. What the threads pull is
// not known yet: a node that was to stay may slide later in the step, not the other way round, and
// those held wrongly make threads between them carry forces a hundred times those at the end.
ModifiedMass::Contact ModifiedMass::enter(Index node, Index body, const Vec3& hit,
                                          const Vec3& end) const {
  const Shape& shape = *(*bodies_)[body].shape;
  const SurfacePoint there = shape.nearest(end);
  const Vec3 normal = shape.nearest(hit).normal;
  const double radius = radius_[node];
  if (friction_ == 0.0) {
    const bool through = there.distance >= radius || there.normal.dot(normal) < kSameSide;
    return make_contact(node, body, through ? hit : end, false);
  }
  const Vec3 way = end - to_body(start_->bodies[body], start_->x[node]);
  const double down = -way.dot(normal), along = (way + down * normal).norm();
  const bool stops = along <= friction_ * down + kRestSlip * step_->h;
  Contact c = make_contact(node, body, hit, stops && !released_[node]);
  const double depth = std::max(0.0, radius - there.distance);
  if (!c.sticks) c.limit = friction_ * mass_[node] * depth / (step_->h * step_->h);
  return c;
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

// Releases what the surface would have to pull; true if there is any. A node that sticks may pull
// only because it is dragged along: it slides before it leaves.
bool ModifiedMass::release(const std::vector<Vec3>& x1, const std::vector<Vec3>& reaction) {
  double largest = 0.0;
  for (const Contact& c : contacts_) largest = std::max(largest, reaction[c.node].norm());
  largest *= step_->reaction_impulse();
  bool changed = false;
  std::erase_if(contacts_, [&](Contact& c) {
    const bool pulls = released_[c.node] < kMostReleases &&
                       normal_impulse(c, x1[c.node], reaction[c.node]) < -1e-9 * largest;
    if (!pulls) return false;
    changed = true;
    if (c.sticks) {
      c.sticks = false;
      return false;
    }
    ++released_[c.node];
    return true;
  });
  return changed;
}

// Coulomb's law; true if anything changed that calls for another solution, or if that is called for
// already. Within a step a node only goes from sticking to sliding; a node that ends a step at rest
// sticks in the next one. So no contact alternates. The limits of all that slides follow the normal
// reactions until these hold on the whole.
bool ModifiedMass::revise_friction(const std::vector<Vec3>& reaction, bool changed) {
  if (friction_ == 0.0) return changed;
  const auto limit_now = [&](const Contact& c) {
    return friction_ * std::max(0.0, reaction[c.node].dot(c.normal));
  };
  double change = 0.0, sum = 0.0;
  for (Contact& c : contacts_) {
    const double limit = limit_now(c);
    sum += limit;
    if (!c.sticks) {
      change += std::abs(limit - c.limit);
      continue;
    }
    const Vec3& f = reaction[c.node];
    if ((f - c.normal * c.normal.dot(f)).norm() <= limit * (1.0 + 1e-9)) continue;
    c.sticks = false;
    changed = true;
  }
  changed |= change > friction_tolerance_ * sum;
  if (changed)
    for (Contact& c : contacts_)
      if (!c.sticks) c.limit = limit_now(c);
  return changed;
}

// Whether a sliding node has come to rest on the body.
bool ModifiedMass::at_rest(const Contact& c) const {
  const Vec3 d = end_[c.node] - carried(c, now_[c.body]);
  return (d - c.normal * c.normal.dot(d)).norm() <= kRestSlip * step_->h;
}

bool ModifiedMass::revise(const std::vector<Vec3>& x1, const std::vector<BodyState>& bodies,
                          const std::vector<Vec3>& reaction, bool) {
  now_ = bodies;
  end_ = x1;
  bool changed = false;
  if (++revisions_ <= kMostRevisions) changed = revise_friction(reaction, release(x1, reaction));
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

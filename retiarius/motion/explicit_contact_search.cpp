// Which nodes are near which bodies, and the planes that stand for the surfaces there.
#include <algorithm>
#include <cmath>

#include "retiarius/motion/explicit_contact.hpp"

namespace retiarius {

namespace {

// By how much a plane may be wrong, as a share of the thread's radius.
constexpr double kPlaneError = 5e-5;
// How far it serves at least, as a share of the gap that the query found.
constexpr double kClearReach = 0.9;
// Cosine between normals of one side of a body.
constexpr double kSameSide = 0.5;
constexpr int kMostPathSteps = 400;
// Rounding may move a coordinate by a little more than its velocity says.
constexpr double kMore = 1.0 + 1e-9;

// A radius that the surface's radii of curvature are not below, m.
double smallest_bend(const Body& body) {
  if (body.kind == ShapeKind::plane) return kInfinity;
  return body.kind == ShapeKind::sphere ? body.shape->bounding_radius() : 0.0;
}

}  // namespace

ExplicitContact::Contact ExplicitContact::watched(Index node, Index body) const {
  Contact c;
  c.node = node;
  c.body = body;
  c.slot = nodes_.layout->slot(node);
  c.mass = (*nodes_.mass)[node];
  c.radius = radius_[node];
  return c;
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

std::vector<ExplicitContact::Contact>::const_iterator ExplicitContact::find(Index node,
                                                                            Index body) const {
  const auto found = std::lower_bound(
      contacts_.begin(), contacts_.end(), std::pair(node, body), [](const Contact& c, auto key) {
        return c.node != key.first ? c.node < key.first : c.body < key.second;
      });
  const bool there = found != contacts_.end() && found->node == node && found->body == body;
  return there ? found : contacts_.end();
}

bool ExplicitContact::active(Index node, Index body) const {
  return find(node, body) != contacts_.end();
}

void ExplicitContact::add(Contact contact) {
  take_back();
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
  due_ = std::min(due_, way_ + limit);
  nodes_.layout->write(limit_.data(), node, Vec3::Constant(limit));
  nodes_.layout->write(origin_.data(), node, nodes_.layout->read(nodes_.x, node));
}

void ExplicitContact::guard_all() {
  for (std::size_t i = 0; i < radius_.size(); ++i) guard(static_cast<Index>(i));
  earliest_ = *std::min_element(until_.begin(), until_.end());
}

void ExplicitContact::query(Contact& c, const Vec3& at) const {
  const Body& body = (*bodies_)[c.body];
  const BodyState& pose = poses_[c.body];
  const SurfacePoint p = body.shape->nearest(body.fixed ? to_body(pose, at) : at);
  c.origin = at;
  c.normal = body.fixed ? Vec3(pose.attitude * p.normal) : p.normal;
  c.distance = p.distance;
  const double clear = std::max(0.0, kClearReach * (p.distance - c.radius));
  c.reach =
      std::max(2.0 * kPlaneError * c.radius * (smallest_bend(body) + c.radius), clear * clear);
}

// Follows a straight path in body axes, advancing by the distance to the surface. True with the
// query where it comes nearer than the radius.
bool ExplicitContact::enters(const Vec3& from, const Vec3& to, Contact& contact) const {
  const double r = contact.radius;
  const double length = (to - from).norm();
  double t = 0.0;
  for (int k = 0; k < kMostPathSteps; ++k) {
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
      Contact c = watched(node, body);
      const Vec3 from = inward(body, old_poses_[b], old), to = inward(body, poses_[b], x);
      if (!enters(from, to, c) && c.distance > (1.0 + kNear) * radius_[node]) continue;
      c.place = c.anchor = from;
      c.relative = relative_velocity(c);
      add(c);
    }
    guard(node);
  };
  if (way_ * kMore >= due_) {
    double slack = kInfinity;
    const long count = kernels::sweeps().outside(nodes_.x, origin_.data(), limit_.data(),
                                                 layout.size(), found_.data(), &slack);
    due_ = way_ + slack;
    for (long k = 0; k < count; ++k) {
      for (long at = 8L * found_[k]; at < 8L * found_[k] + 8; ++at) {
        const auto d = static_cast<std::size_t>(at);
        const double left = limit_[d] - std::abs(nodes_.x[d] - origin_[d]);
        if (!(left >= 0.0))
          look(layout.node_at(at));
        else
          due_ = std::min(due_, way_ + left);
      }
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
  if ((at - c.origin).squaredNorm() <= c.reach) return;
  const Vec3 normal = c.normal;
  const double plane_gap = c.distance + normal.dot(at - c.origin) - radius_[c.node];
  query(c, at);
  if (plane_gap >= 0.0 || c.normal.dot(normal) >= kSameSide) return;
  Contact hit = watched(c.node, c.body);
  if (enters(c.place, at, hit)) {
    c.origin = hit.origin;
    c.normal = hit.normal;
    c.distance = hit.distance;
    c.reach = hit.reach;
  }
}

// Nodes that have left are guarded by their boxes again.
void ExplicitContact::drop_far() {
  if (!any_far_) return;
  any_far_ = false;
  for (std::size_t k = 0; k < contacts_.size();) {
    const Contact& c = contacts_[k];
    if (gap_of(k) <= kFar * c.radius || !c.impulse.isZero(0.0)) {
      ++k;
      continue;
    }
    take_back();
    const Index node = contacts_[k].node;
    contacts_.erase(contacts_.begin() + static_cast<std::ptrdiff_t>(k));
    guard(node);
    earliest_ = std::min(earliest_, until_[node]);
  }
}

}  // namespace retiarius

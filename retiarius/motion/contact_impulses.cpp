#include "retiarius/motion/contact_impulses.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace retiarius {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat36 = Eigen::Matrix<double, 3, 6>;

Mat36 lever_map(const Vec3& lever) {
  Mat36 j;
  j << Mat3::Identity(), -skew(lever);
  return j;
}

void push(const Body& body, BodyState& s, const Vec3& lever, const Vec3& impulse) {
  if (body.fixed) return;
  s.velocity += impulse / body.mass;
  s.angular_momentum += lever.cross(impulse);
}

// The twist of a body after plastic impact with all its touching nodes at once:
// (M + sum m J^T N J) twist = M twist0 + sum m J^T N v.
Vec6 common_twist(const Body& body, const BodyState& s, Index index,
                  const std::vector<double>& mass, const std::vector<SolvedContact>& contacts,
                  const std::vector<Vec3>& v) {
  Mat6 m = Mat6::Zero();
  m.topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
  m.bottomRightCorner<3, 3>() = world_inertia(body, s.attitude);
  Vec6 rhs;
  rhs << body.mass * s.velocity, s.angular_momentum;
  for (const SolvedContact& c : contacts) {
    if (c.body != index) continue;
    const Mat36 j = lever_map(c.point - s.position);
    m += mass[c.node] * j.transpose() * c.blocked * j;
    rhs += mass[c.node] * j.transpose() * (c.blocked * v[c.node]);
  }
  return m.ldlt().solve(rhs);
}

// Friction that goes with a normal impulse of the impact: against the slip, not past its end.
Vec3 friction_impulse(const SolvedContact& c, double normal, const Vec3& relative, double mass,
                      double friction) {
  const Vec3 slip = relative - c.normal * c.normal.dot(relative);
  const double speed = slip.norm();
  if (c.sticks || friction == 0.0 || speed == 0.0) return Vec3::Zero();
  return -std::min(friction * normal, mass * speed) / speed * slip;
}

}  // namespace

void apply_contact_impulses(const Step& step, const std::vector<Body>& bodies,
                            const std::vector<double>& mass, double friction,
                            const std::vector<SolvedContact>& contacts,
                            const std::vector<Vec3>& force, State& now) {
  const State& old = *step.start;
  const double weight = step.reaction_impulse();
  // The touches hold impulses until all are known.
  now.touches.clear();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const SolvedContact& c = contacts[k];
    BodyState& s = now.bodies[c.body];
    now.touches.push_back({c.node, c.body, c.sticks, weight * force[k]});
    push(bodies[c.body], s, c.point - s.position, -now.touches[k].reaction);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Index index = static_cast<Index>(b);
    const bool touched = std::any_of(contacts.begin(), contacts.end(),
                                     [&](const SolvedContact& c) { return c.body == index; });
    if (!touched) continue;
    const BodyState before = now.bodies[b];
    const Vec6 twist = bodies[b].fixed
                           ? Vec6(Vec6::Zero())
                           : common_twist(bodies[b], before, index, mass, contacts, now.v);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const SolvedContact& c = contacts[k];
      if (c.body != index) continue;
      const Vec3 lever = c.point - before.position;
      const Vec3 relative = lever_map(lever) * twist - now.v[c.node];
      Vec3 plastic = mass[c.node] * (c.blocked * relative);
      plastic += friction_impulse(c, plastic.dot(c.normal), -relative, mass[c.node], friction);
      now.touches[k].reaction += plastic;
      now.v[c.node] += plastic / mass[c.node];
      push(bodies[b], now.bodies[b], lever, -plastic);
    }
  }
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const SolvedContact& c = contacts[k];
    const Vec3 impulse = now.touches[k].reaction;
    const Body& body = bodies[c.body];
    const Vec3 before = old.v[c.node] - point_velocity(body, old.bodies[c.body], old.x[c.node]);
    const Vec3 after = now.v[c.node] - point_velocity(body, now.bodies[c.body], c.point);
    const Vec3 mean = 0.5 * (before + after);
    const Vec3 normal = c.normal * c.normal.dot(impulse);
    now.account.impact_loss -= normal.dot(mean);
    now.account.friction_loss -= (impulse - normal).dot(mean);
    if (body.fixed) {
      now.account.outside_impulse += impulse;
      now.account.outside_angular_impulse += now.x[c.node].cross(impulse);
    }
    now.touches[k].reaction = impulse / step.h;
  }
}

}  // namespace retiarius

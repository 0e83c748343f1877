#include "retiarius/motion/barrier_impulses.hpp"

#include <algorithm>

namespace retiarius {

namespace {

bool is_fixed(const std::vector<Body>& bodies, Index owner) {
  return owner != kNet && bodies[static_cast<std::size_t>(owner)].fixed;
}

// Of nodes on bodies: one touch for each node and body, ordered.
void gather_touches(std::vector<Touch>& touches) {
  std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) {
    return a.node != b.node ? a.node < b.node : a.body < b.body;
  });
  std::size_t kept = 0;
  for (const Touch& t : touches) {
    if (kept > 0 && touches[kept - 1].node == t.node && touches[kept - 1].body == t.body) {
      touches[kept - 1].reaction += t.reaction;
      touches[kept - 1].sticks = touches[kept - 1].sticks && t.sticks;
    } else {
      touches[kept++] = t;
    }
  }
  touches.resize(kept);
}

}  // namespace

void apply_barrier_impulses(const Step& step, const std::vector<Body>& bodies, double stick_speed,
                            const std::vector<PairContact>& contacts, State& now) {
  const double weight = step.reaction_impulse();
  now.touches.clear();
  for (const PairContact& c : contacts) {
    const bool on_fixed =
        is_fixed(bodies, c.pair.first_owner) || is_fixed(bodies, c.pair.second_owner);
    for (int i = 0; i < point_count(c.pair.kind); ++i) {
      const Vec3 impulse = weight * c.point_force[i];
      const Index owner = c.places[i].owner;
      if (is_fixed(bodies, owner)) continue;
      if (owner == kNet) {
        const Index body = c.pair.first_owner == kNet ? c.pair.second_owner : c.pair.first_owner;
        if (body != kNet && c.weight[i] != 0.0)
          now.touches.push_back(
              {c.places[i].point, body, c.slip.norm() < stick_speed * step.h, impulse / step.h});
      } else {
        BodyState& s = now.bodies[static_cast<std::size_t>(owner)];
        s.velocity += impulse / bodies[static_cast<std::size_t>(owner)].mass;
        s.angular_momentum += (c.place[i] - s.position).cross(impulse);
      }
      if (!on_fixed) continue;
      now.account.outside_impulse += impulse;
      now.account.outside_angular_impulse += c.place[i].cross(impulse);
    }
    now.account.friction_loss -= weight / step.h * c.friction.dot(c.slip);
  }
  gather_touches(now.touches);
}

void node_forces(const std::vector<PairContact>& contacts, std::size_t nodes,
                 std::vector<Vec3>& force) {
  force.assign(nodes, Vec3::Zero());
  for (const PairContact& c : contacts)
    for (int i = 0; i < point_count(c.pair.kind); ++i)
      if (c.places[i].owner == kNet) force[c.places[i].point] += c.point_force[i];
}

}  // namespace retiarius

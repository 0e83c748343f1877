#include "retiarius/measure/contact_load.hpp"

namespace retiarius {

namespace {

void count(const ContactPair& pair, ContactLoad& load) {
  const bool first = pair.first_owner == kNet, second = pair.second_owner == kNet;
  if (first && second) {
    ++load.threads;
  } else if (!first && !second) {
    ++load.bodies;
  } else if (pair.kind == PairKind::point_triangle || pair.kind == PairKind::point_plane) {
    ++load.faces;
  } else {
    ++load.edges;
  }
}

void add(const PairContact& c, Index owner, const Vec3& force, std::vector<BodyLoad>& loads) {
  if (owner == kNet) return;
  BodyLoad& load = loads[static_cast<std::size_t>(owner)];
  load.force += force;
  load.normal = load.normal.value_or(0.0) + c.force;
  load.friction = load.friction.value_or(0.0) + c.friction.norm();
}

}  // namespace

ContactLoad contact_load(const Simulation& simulation) {
  ContactLoad load;
  load.energy = simulation.contact_energy();
  load.loads.resize(simulation.bodies().size());
  if (!simulation.has_barriers()) {
    for (const Touch& touch : simulation.state().touches)
      load.loads[static_cast<std::size_t>(touch.body)].force -= touch.reaction;
    return load;
  }
  for (BodyLoad& body : load.loads) body.normal = body.friction = 0.0;
  for (const PairContact& c : simulation.contacts()) {
    count(c.pair, load);
    Vec3 on_first = Vec3::Zero();
    for (int i = 0; i < first_count(c.pair.kind); ++i) on_first += c.point_force[i];
    add(c, c.pair.first_owner, on_first, load.loads);
    add(c, c.pair.second_owner, -on_first, load.loads);
  }
  return load;
}

}  // namespace retiarius

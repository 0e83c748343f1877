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

// A thread through each node.
std::vector<Index> threads_of_nodes(const Network& network) {
  std::vector<Index> thread(network.mass.size(), kNone);
  for (const Segment& s : network.segments)
    for (const Index n : {s.a, s.b})
      if (thread[static_cast<std::size_t>(n)] == kNone)
        thread[static_cast<std::size_t>(n)] = s.thread;
  return thread;
}

Vec3 force_on_first(const PairContact& c) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < first_count(c.pair.kind); ++i) sum += c.point_force[i];
  return sum;
}

}  // namespace

std::vector<ContactMark> contact_marks(const Simulation& simulation) {
  const State& state = simulation.state();
  std::vector<ContactMark> marks;
  if (state.touches.empty() && simulation.contacts().empty()) return marks;
  const Network& network = simulation.network();
  const std::vector<Index> thread = threads_of_nodes(network);
  if (!simulation.has_barriers()) {
    for (const Touch& t : state.touches)
      marks.push_back({state.x[static_cast<std::size_t>(t.node)], -t.reaction, t.body,
                       thread[static_cast<std::size_t>(t.node)]});
    return marks;
  }
  const auto thread_of = [&](Index primitive, bool edge) {
    return edge ? network.segments[static_cast<std::size_t>(primitive)].thread
                : thread[static_cast<std::size_t>(primitive)];
  };
  for (const PairContact& c : simulation.contacts()) {
    const bool edges = c.pair.kind == PairKind::edge_edge;
    // A ball's point stands first against a segment.
    const bool swapped = c.pair.first_owner != kNet && c.pair.second_owner == kNet;
    const Vec3 force = force_on_first(c);
    ContactMark mark{c.point, swapped ? force : Vec3(-force),
                     swapped ? c.pair.first_owner : c.pair.second_owner, kNone};
    if (swapped) mark.thread = thread_of(c.pair.second, true);
    if (c.pair.first_owner == kNet) mark.thread = thread_of(c.pair.first, edges);
    marks.push_back(mark);
  }
  return marks;
}

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
    const Vec3 on_first = force_on_first(c);
    add(c, c.pair.first_owner, on_first, load.loads);
    add(c, c.pair.second_owner, -on_first, load.loads);
  }
  return load;
}

}  // namespace retiarius

#include "retiarius/measure/clearance.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {

namespace {

// Rounding of bounds: they are taken this much lower, relative to the lengths they come from.
constexpr double kRounding = 1e-12;

}  // namespace

Clearance::Clearance(const Network& network, const std::vector<Body>& bodies)
    : network_(&network), bodies_(&bodies), node_radius_(network.mass.size(), 0.0) {
  for (const Segment& s : network.segments) {
    const double r = network.materials[s.material].radius;
    segment_radius_.push_back(r);
    node_radius_[s.a] = std::max(node_radius_[s.a], r);
    node_radius_[s.b] = std::max(node_radius_[s.b], r);
  }
  Memory fresh;
  fresh.nodes.resize(network.mass.size());
  fresh.segments.resize(network.segments.size());
  memory_.assign(bodies.size(), fresh);
  place_.resize(network.mass.size());
  bound_.resize(network.mass.size());
}

std::optional<double> Clearance::measure(const State& state) {
  queries_ = 0;
  smallest_ = kInfinity;
  if (bodies_->empty()) return std::nullopt;
  for (std::size_t b = 0; b < bodies_->size(); ++b)
    approach((*bodies_)[b], state.bodies[b], state, memory_[b]);
  return smallest_;
}

// Starts with what was nearest at the last call, so that most others need no query.
void Clearance::approach(const Body& body, const BodyState& pose, const State& state,
                         Memory& memory) {
  const Shape& shape = *body.shape;
  const Mat3 turn = pose.attitude.conjugate().toRotationMatrix();
  for (std::size_t i = 0; i < place_.size(); ++i) place_[i] = turn * (state.x[i] - pose.position);
  bound_nodes(body, memory);
  ask_node(shape, memory, memory.nearest_node);
  if (memory.nearest_segment != kNone) ask_segment(shape, memory, memory.nearest_segment);
  const auto lowest = std::min_element(bound_.begin(), bound_.end()) - bound_.begin();
  ask_node(shape, memory, static_cast<Index>(lowest));
  for (std::size_t i = 0; i < bound_.size(); ++i)
    if (bound_[i] - node_radius_[i] < smallest_) ask_node(shape, memory, static_cast<Index>(i));
  for (std::size_t s = 0; s < segment_radius_.size(); ++s) {
    const Index segment = static_cast<Index>(s);
    if (segment_bound(memory, segment) - segment_radius_[s] < smallest_)
      ask_segment(shape, memory, segment);
  }
}

void Clearance::bound_nodes(const Body& body, const Memory& memory) {
  const double reach = body.shape->bounding_radius();
  for (std::size_t i = 0; i < bound_.size(); ++i) {
    const KnownNode& known = memory.nodes[i];
    const double from_known = known.distance - (place_[i] - known.place).norm();
    const double far = place_[i].norm();
    bound_[i] = std::max(far - reach, from_known) - kRounding * (1.0 + far);
  }
}

// No point of a segment is farther than its length from one end and nearer to the body than the
// distances of both ends let it be.
double Clearance::segment_bound(const Memory& memory, Index segment) const {
  const Segment& s = network_->segments[segment];
  const Vec3 &a = place_[s.a], &b = place_[s.b];
  const double from_ends = 0.5 * (bound_[s.a] + bound_[s.b] - (b - a).norm());
  const KnownSegment& known = memory.segments[segment];
  const double moved = std::max((a - known.a).squaredNorm(), (b - known.b).squaredNorm());
  const double from_known = known.distance - std::sqrt(moved);
  return std::max(from_ends, from_known) - kRounding * (1.0 + a.norm());
}

void Clearance::ask_node(const Shape& shape, Memory& memory, Index node) {
  ++queries_;
  const double distance = shape.nearest(place_[node]).distance;
  memory.nodes[node] = {place_[node], distance};
  bound_[node] = distance - kRounding * (1.0 + place_[node].norm());
  if (distance - node_radius_[node] >= smallest_) return;
  smallest_ = distance - node_radius_[node];
  memory.nearest_node = node;
}

void Clearance::ask_segment(const Shape& shape, Memory& memory, Index segment) {
  ++queries_;
  const Segment& s = network_->segments[segment];
  const Vec3 &a = place_[s.a], &b = place_[s.b];
  const double distance = shape.segment_distance(a, b);
  memory.segments[segment] = {a, b, distance};
  if (distance - segment_radius_[segment] >= smallest_) return;
  smallest_ = distance - segment_radius_[segment];
  memory.nearest_segment = segment;
}

}  // namespace retiarius

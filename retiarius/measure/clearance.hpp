// How near the threads are to the bodies.
#pragma once

#include <optional>
#include <vector>

#include "retiarius/base/archive.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// The smallest signed distance from thread centre line to body surface less the thread's radius,
// over all nodes, segments and bodies; negative where a thread has entered a body.
//
// Signed distances change by no more than the distance moved. So every exact distance once found
// bounds all later ones from below, and a step needs exact queries only where such a bound (or that
// of the body's bounding sphere, or of the segment's two nodes) could fall below the smallest
// distance. The answer is that of asking everywhere.
class Clearance {
 public:
  // Network and bodies must outlive it.
  Clearance(const Network& network, const std::vector<Body>& bodies);

  // m; absent without bodies.
  std::optional<double> measure(const State& state);

  // Exact queries of the last call, for whoever watches the cost.
  long long queries() const { return queries_; }

  // For checkpoints; see base/archive.hpp. Distances found by iteration depend in their last digits
  // on which of them were asked for, hence on what is known.
  void transfer(Archive& archive) { archive(memory_); }

 private:
  // Places (body axes) at which the exact distance of node or segment is known.
  struct KnownNode {
    Vec3 place = Vec3::Zero();
    double distance = -kInfinity;
    void transfer(Archive& archive) { archive(place, distance); }
  };
  struct KnownSegment {
    Vec3 a = Vec3::Zero(), b = Vec3::Zero();
    double distance = -kInfinity;
    void transfer(Archive& archive) { archive(a, b, distance); }
  };
  struct Memory {
    std::vector<KnownNode> nodes;
    std::vector<KnownSegment> segments;
    Index nearest_node = 0;         // where a new search starts
    Index nearest_segment = kNone;  // the same; none before the first
    void transfer(Archive& archive) { archive(nodes, segments, nearest_node, nearest_segment); }
  };

  void approach(const Body& body, const BodyState& pose, const State& state, Memory& memory);
  void bound_nodes(const Body& body, const Memory& memory);
  double segment_bound(const Memory& memory, Index segment) const;
  void ask_node(const Shape& shape, Memory& memory, Index node);
  void ask_segment(const Shape& shape, Memory& memory, Index segment);

  const Network* network_;
  const std::vector<Body>* bodies_;
  std::vector<double> node_radius_;     // m
  std::vector<double> segment_radius_;  // m
  std::vector<Memory> memory_;          // of each body
  std::vector<Vec3> place_;             // of each node in the present body's axes
  std::vector<double> bound_;           // lower, of each node's distance to the present body
  double smallest_ = kInfinity;
  long long queries_ = 0;
};

}  // namespace retiarius

// Finds the pairs of primitives that may come near each other during a motion.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "retiarius/contact/box_tree.hpp"
#include "retiarius/contact/collision_scene.hpp"
#include "retiarius/contact/pair_parts.hpp"
#include "retiarius/contact/thread_neighbours.hpp"
#include "retiarius/contact/thread_pairs.hpp"

namespace retiarius {

// Candidates: every pair whose boxes, swept over the motion and widened by the pair's radii and the
// margin, overlap. So no pair is missing whose surfaces come within `margin` of each other at any t
// in [0, 1]. Which pairs there are:
// - thread on body: node on triangle, segment on edge; sphere's point on segment; node on plane;
// - thread on thread (if asked for): segment on segment, without neighbours along the net; their
//   boxes are swept by the motion beyond the mean one of all nodes, which changes no distance;
// - body on body: point on point, edge, triangle or plane, edge on edge; not two fixed bodies.
// The boxes against a body stand in its axes, where its primitives' tree is built once.
//
// The cost is that of passing once over the net and the bodies' bounds, plus that of what is near.
// Buffers are kept from call to call.
class BroadPhase {
 public:
  struct Options {
    bool self = false;        // thread on thread
    std::vector<bool> fixed;  // of each body; empty: none
    double slack = 0.0;       // of thread on thread, m, see ThreadPairs
    double reach = 0.0;       // what the margin is more there, m
  };

  // The scene and, with `self`, the neighbours must outlive this.
  BroadPhase(const CollisionScene& scene, const ThreadNeighbours* neighbours, Options options);

  // Nodes move from x by dx, bodies as given; margin >= 0, m. The pairs are in ascending order and
  // unique, whatever the number of threads; they stand until the next call.
  const std::vector<ContactPair>& find(const std::vector<Vec3>& x, const std::vector<Vec3>& dx,
                                       const std::vector<BodyTwist>& bodies, double margin);

  // From the next call on: pairs of threads and nothing else.
  void leave_bodies_out(bool out) { bodies_left_out_ = out; }

  const std::vector<ContactPair>& pairs() const { return pairs_; }

  // Of each pair, which one it was among those found before; kNone if it was not.
  const std::vector<Index>& before() const { return before_; }

 private:
  // A body's primitives, in its axes.
  struct BodyTrees {
    BoxTree edges, triangles;
  };
  using Found = PairParts::List;

  template <class Call>
  void each(std::size_t count, Call&& call) {
    parts_.each(count, std::forward<Call>(call));
  }

  Box segment_box(Index segment) const;
  Box body_box(Index body) const;
  PointMotion node(Index k) const;
  PointMotion point(Index body, Index k) const;

  void net_on_body(Index body, double margin);
  void nodes_on_body(Index body, double margin);
  void segments_on_body(Index body, double margin);
  void net_on_plane(Index body, double margin);
  void body_on_plane(Index body, Index plane, double margin);
  void body_on_body(Index first, Index second, double margin);
  void points_on_surface(Index from, Index to, double margin);
  void edges_on_edges(Index from, Index to, double margin);
  void collect(const Found& of_threads);
  void look_up_before();

  const CollisionScene* scene_;
  Options options_;
  bool bodies_left_out_ = false;
  std::vector<BodyTrees> trees_;
  const std::vector<Vec3>*x_ = nullptr, *dx_ = nullptr;
  const std::vector<BodyTwist>* twists_ = nullptr;

  std::optional<ThreadPairs> threads_;
  std::vector<Box> boxes_;    // of segments, in world axes
  std::vector<Box> in_axes_;  // of nodes, in the axes of a body
  PairParts parts_;
  Found pairs_, with_bodies_, found_before_;
  std::vector<Index> before_;
};

}  // namespace retiarius

// Finds the pairs of primitives that may come near each other during a motion.
#pragma once

#include <vector>

#include "retiarius/contact/box_tree.hpp"
#include "retiarius/contact/collision_scene.hpp"
#include "retiarius/contact/thread_neighbours.hpp"

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

 private:
  // A body's primitives, in its axes.
  struct BodyTrees {
    BoxTree edges, triangles;
  };
  using Found = std::vector<ContactPair>;

  // Calls call(k, found) for k in [0, count), in parallel ranges that have a list each.
  template <class Call>
  void each(std::size_t count, Call&& call);

  Box segment_box(Index segment, const Vec3& drift) const;
  Box body_box(Index body) const;
  PointMotion node(Index k) const;
  PointMotion point(Index body, Index k) const;

  void net_on_net(double margin);
  void net_on_body(Index body, double margin);
  void nodes_on_body(Index body, double margin);
  void segments_on_body(Index body, double margin);
  void net_on_plane(Index body, double margin);
  void body_on_plane(Index body, Index plane, double margin);
  void body_on_body(Index first, Index second, double margin);
  void points_on_surface(Index from, Index to, double margin);
  void edges_on_edges(Index from, Index to, double margin);
  void collect();

  const CollisionScene* scene_;
  const ThreadNeighbours* neighbours_;
  Options options_;
  bool bodies_left_out_ = false;
  std::vector<BodyTrees> trees_;
  const std::vector<Vec3>*x_ = nullptr, *dx_ = nullptr;
  const std::vector<BodyTwist>* twists_ = nullptr;

  BoxTree net_tree_;
  std::vector<Box> boxes_;     // of segments, in world axes
  std::vector<Box> drifting_;  // the same without the mean motion
  std::vector<Box> in_axes_;   // of nodes, in the axes of a body
  std::vector<Found> parts_;   // what each range of a loop found
  std::size_t used_parts_ = 0;
  Found pairs_;
};

}  // namespace retiarius

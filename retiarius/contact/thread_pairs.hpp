// Finds the pairs of segments of the net that may come near each other during a motion.
#pragma once

#include <vector>

#include "retiarius/contact/box_tree.hpp"
#include "retiarius/contact/collision_mesh.hpp"
#include "retiarius/contact/pair_parts.hpp"
#include "retiarius/contact/thread_neighbours.hpp"

namespace retiarius {

// Every pair whose boxes, swept over the motion and widened by radius and half the margin, overlap,
// neighbours along the net left out. The net's mean place and motion are taken off first, which
// changes no distance.
//
// With a slack, boxes are widened by it once more and held: while a segment stays within its box,
// motion after motion, its pairs stand, and only those of the others are looked for again. Pairs of
// earlier motions may then be among those found.
class ThreadPairs {
 public:
  // The mesh and the neighbours (null: none) must outlive this. slack >= 0, m.
  ThreadPairs(const CollisionMesh& net, const ThreadNeighbours* neighbours, double slack);

  // Nodes move from x by dx; margin >= 0, m. In ascending order and unique, until the next call.
  const PairParts::List& find(const std::vector<Vec3>& x, const std::vector<Vec3>& dx,
                              double margin);

 private:
  void sweep(const std::vector<Vec3>& x, const std::vector<Vec3>& dx, double margin);
  void find_left();
  void hold(Index segment);
  void find_all();
  void find_those_left();
  void add(Index s, Index t, PairParts::List& found) const;

  const CollisionMesh* net_;
  const ThreadNeighbours* neighbours_;
  double slack_;
  Vec3 origin_ = Vec3::Zero();  // mean place of the nodes when all was looked for last
  std::vector<Box> swept_;      // of this motion, about that place
  std::vector<Box> held_;       // what the pairs are those of
  std::vector<char> has_left_;  // whether each segment leaves the box held
  std::vector<Index> left_;     // those that do
  BoxTree tree_;                // over the boxes held
  PairParts parts_;
  PairParts::List pairs_, standing_, found_;
};

}  // namespace retiarius

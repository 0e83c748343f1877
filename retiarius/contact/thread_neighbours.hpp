// Which segments are too near along the net to touch each other.
#pragma once

#include <vector>

#include "retiarius/net/network.hpp"

namespace retiarius {

// Two segments are neighbours if they share a node or if the shortest way between them along the
// net is, at rest, shorter than `multiple` times the sum of their radii, however many segments lie
// between: so a finer division of the same thread excludes the same lengths of thread.
class ThreadNeighbours {
 public:
  static constexpr double kMultiple = 3.0;

  explicit ThreadNeighbours(const Network& network, double multiple = kMultiple);

  bool are_neighbours(Index first, Index second) const;

 private:
  std::vector<Index> start_, others_;  // of each segment, ascending
};

}  // namespace retiarius

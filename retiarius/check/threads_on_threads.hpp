// Threads against each other, at a state and from it to the next.
#pragma once

#include <utility>
#include <vector>

#include "retiarius/check/checked_run.hpp"
#include "retiarius/check/tally.hpp"

namespace retiarius::check {

// Segments that share a node or are nearer along the net, at rest, than this many times the sum of
// their radii do not count.
inline constexpr double kNeighbourMultiple = 3.0;

class ThreadsOnThreads {
 public:
  explicit ThreadsOnThreads(const CheckedRun& run);

  // Adds what is wrong at `now` and, unless `next` is null, on the way to it.
  void check(const FrameData& now, const FrameData* next, const ContactCheckOptions& options,
             Tally& tally);

 private:
  void check_pair(Index s, Index t, const FrameData& now, const FrameData* next,
                  const ContactCheckOptions& options, Tally& tally) const;
  bool are_neighbours(Index s, Index t) const;

  const CheckedRun& run_;
  std::vector<std::pair<Index, Index>> neighbours_;  // s < t, in order
  std::vector<Vec3> low_, high_;                     // of each segment's way, radius included
  std::vector<Index> by_x_;                          // segments by their lowest x
};

}  // namespace retiarius::check

// How a net's nodes and segments are laid out for the explicit integrator's sweeps.
#pragma once

#include <vector>

#include "retiarius/base/line_vector.hpp"
#include "retiarius/motion/sweep_kernels.hpp"
#include "retiarius/net/network.hpp"
#include "retiarius/solve/aligned_array.hpp"

namespace retiarius {

// Threads are cut into chains of one material, and eight chains of like length lie side by side, a
// chain a lane. A node that one chain runs through, as all eight do in that row, needs nobody
// else: it moves as soon as the sweep has passed. All others (knots, ends, chosen nodes) are
// shared: read from their own places, and moved by the sum of what the chains left at their ends.
class SweepLayout {
 public:
  // alone: nodes that must be shared, for each node whether (or empty).
  SweepLayout(const Network& network, const std::vector<char>& alone);

  // Where a node's coordinates are in an array of size().
  struct Slot {
    long offset = 0, stride = 1;
  };
  const Slot& slot(Index node) const { return slots_[node]; }
  Index node_at(long offset) const { return nodes_[offset]; }  // kNone: padding
  bool shared(Index node) const { return slots_[node].stride == 1; }
  long size() const { return static_cast<long>(nodes_.size()); }  // a multiple of 8

  Vec3 read(const double* array, Index node) const {
    const Slot& s = slots_[node];
    const double* p = array + s.offset;
    return {p[0], p[s.stride], p[2 * s.stride]};
  }
  void write(double* array, Index node, const Vec3& value) const {
    const Slot& s = slots_[node];
    double* p = array + s.offset;
    p[0] = value.x();
    p[s.stride] = value.y();
    p[2 * s.stride] = value.z();
  }

  // Prepares sub-steps of length h, s, from positions and velocities of the nodes: strain rates are
  // remembered from before. stretch: false leaves the segments without stiffness.
  void begin(const std::vector<Vec3>& x, const std::vector<Vec3>& v, double h, bool stretch);

  const std::vector<kernels::SweepGroup>& groups() const { return groups_; }
  const std::vector<kernels::SweepRun>& runs() const { return runs_; }
  // The masses and ends of a state for the kernels.
  void bind(kernels::SweepState& state) const;
  // Force of the segments on a shared node at the last sweep, N.
  Vec3 force(Index shared_node) const;
  // The last recorded tension of each segment, N.
  void tensions(std::vector<double>& out) const;

 private:
  struct Chain {
    std::vector<Index> nodes, segments;
    Index material = 0;
  };
  struct Block {  // where a group's arrays begin
    std::size_t place = 0, shared = 0, inverse = 0, ends = 0, segment = 0;
    long rows = 0;
    Index material = 0;
    std::size_t rest = 0, stiffness = 0;
  };

  std::vector<Chain> cut_chains() const;
  void place_nodes(const std::vector<std::vector<const Chain*>>& groups,
                   const std::vector<char>& alone);
  void place_groups(const std::vector<std::vector<const Chain*>>& groups);
  void link_ends();
  void make_groups();
  void add_laws(Block& block, kernels::SweepGroup& group);

  const Network* network_;
  std::vector<Slot> slots_;
  std::vector<Index> nodes_;  // at each offset
  std::vector<Block> blocks_;
  std::vector<int> place_, shared_;
  std::vector<Index> segments_;  // of each lane of each segment row, or kNone
  std::vector<Index> ends_of_;   // node of each lane of the shared rows, or kNone
  std::vector<Index> shared_nodes_;
  LineVector rest_, stiffness_, inverse_;  // in rows that several rows of groups may share
  LineVector slack_;                       // as many zeros as stiffnesses
  LineVector last_, before_, drag_, tension_;
  LineVector inverse_shared_, inverse_rows_;
  mutable AlignedArray ends_;
  std::vector<int> incidences_;
  std::vector<int> first_end_, end_count_;  // of each shared node
  std::vector<kernels::SweepGroup> groups_;
  std::vector<kernels::SweepRun> runs_;
};

}  // namespace retiarius

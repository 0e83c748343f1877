// The planes that stand for surfaces near nodes, side by side as the kernels want them.
#pragma once

#include <vector>

#include "retiarius/base/line_vector.hpp"
#include "retiarius/base/vec.hpp"
#include "retiarius/motion/sweep_layout.hpp"

namespace retiarius {

class SurfacePlanes {
 public:
  struct Plane {
    Vec3 origin = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double gap = 0.0;    // at the origin, m
    double reach = 0.0;  // distance from there within which it serves, squared, m2
  };

  // Node k lies at slots[k] of arrays of `size` numbers; its plane is to be set.
  void lay_out(const std::vector<SweepLayout::Slot>& slots, long size);
  void set_plane(std::size_t k, const Plane& plane);
  // The gap beyond which node k need not be watched, m.
  void set_far(std::size_t k, double far) { far_[lanes_[k]] = far; }

  // Of node k at the end of a sub-step: its gap, m, and velocity, m/s.
  double gap(std::size_t k) const { return gap_[lanes_[k]]; }
  Vec3 velocity(std::size_t k) const;
  void set_motion(std::size_t k, double gap, const Vec3& velocity);

  // Keeps gap and velocity of the nodes that have stayed clear of their planes, and returns the
  // others. far: set where one that is clear need not be watched.
  const std::vector<int>& touched(const double* x, const double* v, bool& far);

 private:
  std::size_t add_block(int place);

  std::vector<std::size_t> lanes_;  // of each node
  std::vector<int> nodes_;          // of each lane, or -1
  std::vector<int> place_, shared_, found_;
  std::vector<std::size_t> block_of_;  // of each row, by the place where it begins
  LineVector origin_, normal_, offset_, reach_, far_, gap_, velocity_;
};

}  // namespace retiarius

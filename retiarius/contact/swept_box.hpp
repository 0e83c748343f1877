// Boxes that hold the path of a point in the axes of a moving body.
#pragma once

#include "retiarius/contact/box_tree.hpp"
#include "retiarius/contact/point_motion.hpp"

namespace retiarius {

// The axes of a body along its twist.
class MovingAxes {
 public:
  explicit MovingAxes(const BodyTwist& twist);

  // A box about the path of a point as the body sees it: about its two ends, widened by an eighth
  // of a bound of its second derivative, by which a path leaves its chord at most.
  Box box(const PointMotion& point) const;

 private:
  Mat3 to_start_, to_end_;
  Vec3 start_, end_, move_;
  double turn_;  // rad
};

inline Box widened(const Box& box, double by) {
  return {box.min() - Vec3::Constant(by), box.max() + Vec3::Constant(by)};
}

}  // namespace retiarius

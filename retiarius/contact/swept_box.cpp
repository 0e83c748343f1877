#include "retiarius/contact/swept_box.hpp"

namespace retiarius {
namespace {

Box box_of(const Vec3& a, const Vec3& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

Mat3 turned(const BodyTwist& twist) {
  const double angle = twist.rotation.norm();
  Mat3 start = twist.attitude.toRotationMatrix();
  if (!(angle > 0.0)) return start;
  return Eigen::AngleAxisd(angle, twist.rotation / angle).toRotationMatrix() * start;
}

}  // namespace

MovingAxes::MovingAxes(const BodyTwist& twist)
    : to_start_(twist.attitude.toRotationMatrix().transpose()),
      to_end_(turned(twist).transpose()),
      start_(twist.position),
      end_(twist.position + twist.translation),
      move_(twist.translation),
      turn_(twist.rotation.norm()) {}

Box MovingAxes::box(const PointMotion& point) const {
  const Vec3 start = point.at(0.0) - start_, end = point.at(1.0) - end_;
  const Box chord = box_of(to_start_ * start, to_end_ * end);
  // With z from the mass centre and w the twist's rotation, the body sees the acceleration
  // z'' - 2 w x z' + w x (w x z).
  const double own = point.largest_acceleration();
  if (turn_ == 0.0 && own == 0.0) return chord;
  const double speed = (point.move - move_).norm() + point.turn.cross(point.arm).norm();
  const double reach = start.norm() + speed;
  const double bend = own + 2.0 * turn_ * speed + turn_ * turn_ * reach;
  return widened(chord, bend / 8.0);
}

}  // namespace retiarius

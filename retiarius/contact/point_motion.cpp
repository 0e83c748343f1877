#include "retiarius/contact/point_motion.hpp"

#include <cmath>

namespace retiarius {

BodyTwist motion_between(const BodyState& start, const BodyState& end) {
  Quat turn = end.attitude * start.attitude.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const double sine = turn.vec().norm();
  const double angle = 2.0 * std::atan2(sine, turn.w());
  // angle / sine is 2 to rounding for small turns.
  const Vec3 rotation = turn.vec() * (sine > 1e-9 ? angle / sine : 2.0);
  return {start.position, start.attitude, end.position - start.position, rotation};
}

BodyTwist at_rest(const BodyState& state) {
  return {state.position, state.attitude, Vec3::Zero(), Vec3::Zero()};
}

Vec3 PointMotion::turned(double t) const {
  const double size = turn.norm();
  if (!(size > 0.0)) return arm;
  const double angle = t * size;
  const Vec3 axis = turn / size;
  const double half = std::sin(0.5 * angle);
  // 1 - cos without cancellation.
  return arm + std::sin(angle) * axis.cross(arm) + 2.0 * half * half * axis.cross(axis.cross(arm));
}

Vec3 PointMotion::velocity(double t) const {
  if (turn.isZero(0.0)) return move;
  return move + turn.cross(turned(t));
}

double PointMotion::largest_acceleration() const {
  if (turn.isZero(0.0)) return 0.0;
  return turn.norm() * turn.cross(arm).norm();
}

PointMotion node_motion(const Vec3& start, const Vec3& move) {
  return {start, move, Vec3::Zero(), Vec3::Zero()};
}

PointMotion body_point_motion(const BodyTwist& body, const Vec3& point_in_body) {
  return {body.position, body.translation, body.attitude * point_in_body, body.rotation};
}

PairPositions PairMotion::at(double t) const {
  PairPositions p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = points[i].at(t);
  return p;
}

}  // namespace retiarius

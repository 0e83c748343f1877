// How points move from one state to the next: nodes straight, bodies by constant twist.
#pragma once

#include "retiarius/base/vec.hpp"
#include "retiarius/contact/contact_pair.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

// A body's motion over t in [0, 1]: the mass centre by t translation, the attitude by the rotation
// vector t rotation (world axes).
struct BodyTwist {
  Vec3 position = Vec3::Zero();  // at t = 0, of the mass centre
  Quat attitude = Quat::Identity();
  Vec3 translation = Vec3::Zero();  // m
  Vec3 rotation = Vec3::Zero();     // rad
};

// The motion between two states: the shorter of the two turns.
BodyTwist motion_between(const BodyState& start, const BodyState& end);

// A body that stays where it is.
BodyTwist at_rest(const BodyState& state);

// A point's motion: x(t) = anchor + t move + exp(t [turn]x) arm. A node's arm and turn are 0.
struct PointMotion {
  Vec3 anchor = Vec3::Zero();
  Vec3 move = Vec3::Zero();
  Vec3 arm = Vec3::Zero();
  Vec3 turn = Vec3::Zero();

  Vec3 at(double t) const {
    const Vec3 straight = anchor + t * move;
    return turn.isZero(0.0) ? Vec3(straight + arm) : Vec3(straight + turned(t));
  }
  Vec3 velocity(double t) const;        // dx/dt
  double largest_acceleration() const;  // bound of |d2x/dt2|
  Vec3 turned(double t) const;          // exp(t [turn]x) arm
};

PointMotion node_motion(const Vec3& start, const Vec3& move);
PointMotion body_point_motion(const BodyTwist& body, const Vec3& point_in_body);

// The motion of a pair's points; entries as in PairPositions.
struct PairMotion {
  PairKind kind = PairKind::point_point;
  std::array<PointMotion, 4> points;

  PairPositions at(double t) const;
};

}  // namespace retiarius

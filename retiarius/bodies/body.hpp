// A rigid body: shape and mass properties (immutable), its free motion and its pose.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "retiarius/base/vec.hpp"
#include "retiarius/bodies/shape.hpp"
#include "retiarius/bodies/spec.hpp"
#include "retiarius/state/state.hpp"

namespace retiarius {

struct Body {
  std::string name;
  std::shared_ptr<const Shape> shape;
  ShapeKind kind = ShapeKind::sphere;
  bool fixed = false;
  double mass = 0.0;            // kg; infinite for a fixed body
  Mat3 inertia = Mat3::Zero();  // body axes, about the mass centre, kg m2; zero for a fixed body
  BodyState initial;
  std::optional<double> friction;  // Coulomb coefficient of its surface; absent: the mission's
};

// Builds body and initial state. Throws InputError.
Body build_body(const BodySpec& spec, const std::string& folder);

// Spin in world axes, rad/s, from attitude and angular momentum; zero for a fixed body.
Vec3 spin(const Body& body, const BodyState& state);

// Inertia about the mass centre in world axes, kg m2.
Mat3 world_inertia(const Body& body, const Quat& attitude);

// Motion over time h with constant velocity and constant angular momentum (no force, no torque):
// attitude by a fourth-order Lie-group scheme with enough substeps for an attitude error below
// 1e-10 rad a step. The angular momentum stays the same bit for bit. A fixed body stays where it
// is. Throws RunError for a body that turns by more than 1000 rad.
BodyState free_motion(const Body& body, const BodyState& state, double h);

// `state` displaced by a translation and turned by a rotation vector (world axes, about the mass
// centre); velocity and angular momentum stay.
BodyState displaced(const BodyState& state, const Vec3& translation, const Vec3& rotation);

double kinetic_energy(const Body& body, const BodyState& state);  // J; 0 for a fixed body

inline Vec3 to_body(const BodyState& s, const Vec3& world) {
  return s.attitude.conjugate() * (world - s.position);
}
inline Vec3 to_world(const BodyState& s, const Vec3& body) {
  return s.attitude * body + s.position;
}
// Velocity of the body's material point that is at `world`, m/s.
Vec3 point_velocity(const Body& body, const BodyState& state, const Vec3& world);

}  // namespace retiarius

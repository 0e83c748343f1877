#include "retiarius/bodies/body.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/free_rotation.hpp"

namespace retiarius {
namespace {

[[noreturn]] void refuse(const Body& body, const std::string& message) {
  throw InputError(body.name + ": " + message);
}

void check_finite(const Body& body, const char* key, const Vec3& value) {
  if (value.allFinite()) return;
  refuse(body, fmt::format("{} is [{}, {}, {}]; its numbers must be finite", key, value.x(),
                           value.y(), value.z()));
}

void check_positive(const Body& body, const char* key, double value, const char* unit) {
  if (std::isfinite(value) && value > 0.0) return;
  refuse(body, fmt::format("{} is {} {}; it must be positive and finite", key, value, unit));
}

double build_mass(const Body& body, const BodySpec& spec, const SolidProperties& solid) {
  if (spec.mass) check_positive(body, "mass", *spec.mass, "kg");
  if (spec.density) check_positive(body, "density", *spec.density, "kg/m3");
  if (spec.mass && spec.density) refuse(body, "give mass or density, not both");
  if (body.fixed) return kInfinity;
  if (spec.mass) return *spec.mass;
  if (spec.density) return *spec.density * solid.volume;
  refuse(body, "a free body needs mass (kg) or density (kg/m3)");
}

// No rigid body has a principal moment above the sum of the other two.
Mat3 build_given_inertia(const Body& body, const std::array<double, 3>& moments) {
  const Vec3 value(moments[0], moments[1], moments[2]);
  for (int k = 0; k < 3; ++k) {
    check_positive(body, fmt::format("inertia[{}]", k).c_str(), value[k], "kg m2");
    if (value[k] <= (value.sum() - value[k]) * (1.0 + 1e-12)) continue;
    refuse(body, fmt::format("inertia[{}] is {} kg m2, more than the sum of the other two ({} kg "
                             "m2); no rigid body has such moments",
                             k, value[k], value.sum() - value[k]));
  }
  return value.asDiagonal();
}

void check_fixed(const Body& body, const BodySpec& spec) {
  if (body.fixed && (!spec.velocity.isZero(0.0) || !spec.spin_deg.isZero(0.0))) {
    refuse(body,
           "a fixed body cannot have velocity or spin_deg; leave them out or set motion = "
           "\"free\"");
  }
  if (!body.fixed && body.kind == ShapeKind::plane) {
    refuse(body, "a plane has no mass and must be fixed; set motion = \"fixed\"");
  }
}

}  // namespace

Body build_body(const BodySpec& spec, const std::string& folder) {
  Body body;
  body.name = spec.name.empty() ? "target" : spec.name;
  body.kind = spec.shape;
  body.fixed = spec.motion == BodyMotion::fixed;
  check_finite(body, "position", spec.position);
  check_finite(body, "attitude_deg", spec.attitude_deg);
  check_finite(body, "velocity", spec.velocity);
  check_finite(body, "spin_deg", spec.spin_deg);
  check_fixed(body, spec);
  body.shape = build_shape(spec, folder).shape;

  const SolidProperties solid = body.shape->solid();
  body.mass = build_mass(body, spec, solid);
  if (spec.inertia) body.inertia = build_given_inertia(body, *spec.inertia);
  if (body.fixed) {
    body.inertia.setZero();
  } else if (!spec.inertia) {
    body.inertia = body.mass / solid.volume * solid.inertia;
  }
  body.friction = spec.friction;
  body.initial.position = spec.position;
  body.initial.attitude = rotation(spec.attitude_deg * radians(1.0)).normalized();
  body.initial.velocity = spec.velocity;
  const Vec3 body_spin = spec.spin_deg * radians(1.0);
  body.initial.angular_momentum = body.initial.attitude * (body.inertia * body_spin);
  return body;
}

Vec3 spin(const Body& body, const BodyState& state) {
  if (body.fixed) return Vec3::Zero();
  const Vec3 momentum = state.attitude.conjugate() * state.angular_momentum;
  return state.attitude * (body.inertia.inverse() * momentum);
}

Mat3 world_inertia(const Body& body, const Quat& attitude) {
  const Mat3 turn = attitude.toRotationMatrix();
  return turn * body.inertia * turn.transpose();
}

BodyState free_motion(const Body& body, const BodyState& state, double h) {
  if (body.fixed) return state;
  BodyState next = state;
  next.position += h * state.velocity;
  if (state.angular_momentum.isZero(0.0)) return next;
  const Mat3 inverse = body.inertia.inverse();
  // The spin never exceeds the angular momentum over the smallest moment.
  const double smallest =
      Eigen::SelfAdjointEigenSolver<Mat3>(body.inertia, Eigen::EigenvaluesOnly).eigenvalues()[0];
  const double angle = state.angular_momentum.norm() / smallest * std::abs(h);
  next.attitude = turn_freely(inverse, state.attitude, state.angular_momentum, h,
                              free_rotation_substeps(angle));
  return next;
}

BodyState displaced(const BodyState& state, const Vec3& translation, const Vec3& turn) {
  BodyState next = state;
  next.position += translation;
  if (!turn.isZero(0.0)) next.attitude = (rotation(turn) * state.attitude).normalized();
  return next;
}

double kinetic_energy(const Body& body, const BodyState& state) {
  if (body.fixed) return 0.0;
  return 0.5 * body.mass * state.velocity.squaredNorm() +
         0.5 * state.angular_momentum.dot(spin(body, state));
}

Vec3 point_velocity(const Body& body, const BodyState& state, const Vec3& world) {
  if (body.fixed) return Vec3::Zero();
  return state.velocity + spin(body, state).cross(world - state.position);
}

}  // namespace retiarius

// Bodies and tiny nets for contact tests.
#pragma once

#include "retiarius/bodies/body.hpp"
#include "tests/motion/advance.hpp"
#include "tests/state/small_nets.hpp"

namespace retiarius::testing {

inline constexpr double kRadius = 1e-3;  // of the thread, m

inline Body fixed_plane(const Vec3& attitude_deg = Vec3::Zero()) {
  BodySpec spec;
  spec.shape = ShapeKind::plane;
  spec.motion = BodyMotion::fixed;
  spec.attitude_deg = attitude_deg;
  return build_body(spec, "");
}

inline Body sphere(double radius, double mass, const Vec3& position,
                   BodyMotion motion = BodyMotion::free, const Vec3& spin_deg = Vec3::Zero()) {
  BodySpec spec;
  spec.shape = ShapeKind::sphere;
  spec.radius = radius;
  if (motion == BodyMotion::free) spec.mass = mass;
  spec.motion = motion;
  spec.position = position;
  spec.spin_deg = spin_deg;
  return build_body(spec, "");
}

inline Body box(const Vec3& size, double mass, const Vec3& position,
                BodyMotion motion = BodyMotion::free, const Vec3& spin_deg = Vec3::Zero()) {
  BodySpec spec;
  spec.shape = ShapeKind::box;
  spec.size = size;
  if (motion == BodyMotion::free) spec.mass = mass;
  spec.motion = motion;
  spec.position = position;
  spec.spin_deg = spin_deg;
  return build_body(spec, "");
}

// Two nodes of 0.5 kg, 0.1 m apart along y, joined by a soft tension-only thread.
inline Network two_masses(const Vec3& middle, const Vec3& velocity = Vec3::Zero()) {
  Material m = thread_material(100.0, 1e-9, kRadius);
  m.compression = false;
  Network net = chain({middle - Vec3(0, 0.05, 0), middle + Vec3(0, 0.05, 0)}, m);
  net.mass = {0.5, 0.5};
  net.velocity = {velocity, velocity};
  return net;
}

inline IntegratorSpec with(Method method, double tolerance = 1e-8) {
  IntegratorSpec spec;
  spec.method = method;
  spec.tolerance = tolerance;
  return spec;
}

inline ContactSpec touching(double friction = 0.0) {
  return {ContactMethod::modified_mass, friction};
}

inline constexpr Method kDynamic[] = {Method::implicit_euler, Method::newmark,
                                      Method::midpoint,       Method::generalised_alpha,
                                      Method::tr_bdf2,        Method::explicit_differences};

}  // namespace retiarius::testing

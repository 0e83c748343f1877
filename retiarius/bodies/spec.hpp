// What a mission says about a rigid body ([target], [[target]]): plain data.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "retiarius/base/vec.hpp"

namespace retiarius {

enum class ShapeKind { sphere, box, cylinder, capsule, cone, plane, mesh };
enum class BodyMotion { free, fixed };

struct BodySpec {
  std::string name;                     // default: "target", "target1", ...
  ShapeKind shape = ShapeKind::sphere;  // required
  double radius = 0.0;                  // m: sphere, cylinder, capsule, cone (base)
  double length =
      0.0;  // m: cylinder, capsule (between the caps' centres), cone (height); along body z
  Vec3 size = Vec3::Zero();       // m: box edges along body x, y, z
  std::string file;               // mesh: STL or OBJ; relative to the mission file
  double scale = 1.0;             // mesh: factor from file units to metres
  std::optional<double> mass;     // kg; required for free bodies unless density is given
  std::optional<double> density;  // kg/m3; mass from volume
  std::optional<std::array<double, 3>>
      inertia;  // kg m2, principal, along body axes; default: homogeneous solid
  BodyMotion motion = BodyMotion::free;
  Vec3 position = Vec3::Zero();      // m, of the mass centre (plane: a point of it)
  Vec3 attitude_deg = Vec3::Zero();  // rotation vector body to world, degrees
  Vec3 velocity = Vec3::Zero();      // m/s
  Vec3 spin_deg = Vec3::Zero();      // deg/s, body axes
  std::optional<double> friction;    // Coulomb coefficient of its surface; default: [contact]'s
};

}  // namespace retiarius

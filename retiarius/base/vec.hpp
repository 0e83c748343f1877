// Vectors and 3x3 blocks: the small linear algebra that every room shares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace retiarius {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

// Index of a node, segment, joint, thread, body or block; -1 where "none" is meant.
using Index = std::int32_t;
inline constexpr Index kNone = -1;

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline constexpr double radians(double degrees) { return degrees * (kPi / 180.0); }
inline constexpr double degrees(double radians) { return radians * (180.0 / kPi); }

// Matrix of the cross product: skew(a) * b == a.cross(b).
inline Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace retiarius

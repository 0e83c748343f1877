#include "retiarius/campaign/variable.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/campaign/normal.hpp"
#include "retiarius/campaign/statistics.hpp"
#include "retiarius/mission/key.hpp"

namespace retiarius {

namespace {

constexpr double kPi = 3.14159265358979323846;

double radians_of(double degrees) { return degrees * (kPi / 180.0); }
double degrees_of(double radians) { return radians * (180.0 / kPi); }

double truncated_normal(const VariableSpec& v, double share) {
  // Shares of the lower tail keep their digits; those of an upper one are taken mirrored.
  const double sign = v.low > v.mean ? -1.0 : 1.0;
  const double a = sign * ((sign > 0 ? v.low : v.high) - v.mean) / v.deviation;
  const double b = sign * ((sign > 0 ? v.high : v.low) - v.mean) / v.deviation;
  const double below = normal_share(a), above = normal_share(b);
  const double part = sign > 0 ? share : 1.0 - share;
  const double z = normal_quantile(std::clamp(below + part * (above - below), 1e-300, 1 - 1e-16));
  return std::clamp(v.mean + sign * v.deviation * z, v.low, v.high);
}

double quantile(const VariableSpec& v, double share) {
  switch (v.distribution) {
    case Distribution::uniform:
      return std::clamp(v.low + share * (v.high - v.low), v.low, v.high);
    case Distribution::normal:
      return v.mean + v.deviation * normal_quantile(share);
    case Distribution::truncated_normal:
      return truncated_normal(v, share);
    case Distribution::lognormal:
      return v.median * std::exp(v.deviation * normal_quantile(share));
    default:
      throw Error("a variable of another kind has no quantile");
  }
}

Quat attitude(std::span<const double> angles) {
  return Quat(Eigen::AngleAxisd(radians_of(angles[0]), Vec3::UnitZ()) *
              Eigen::AngleAxisd(radians_of(angles[1]), Vec3::UnitY()) *
              Eigen::AngleAxisd(radians_of(angles[2]), Vec3::UnitX()));
}

// 2 atan2(|v|, w) about v; the shorter way round.
Vec3 rotation_vector_deg(Quat q) {
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const double sine = q.vec().norm();
  if (sine == 0.0) return Vec3::Zero();
  return q.vec() * (degrees_of(2.0 * std::atan2(sine, q.w())) / sine);
}

Vec3 direction(const VariableSpec& v, std::span<const double> angles) {
  const Vec3 axis = v.axis.normalized();
  Eigen::Index farthest = 0;
  axis.cwiseAbs().minCoeff(&farthest);
  const Vec3 unit = Vec3::Unit(farthest);
  const Vec3 first = (unit - axis * axis.dot(unit)).normalized();
  const Vec3 second = axis.cross(first);
  const double angle = radians_of(angles[0]), azimuth = radians_of(angles[1]);
  return std::cos(angle) * axis +
         std::sin(angle) * (std::cos(azimuth) * first + std::sin(azimuth) * second);
}

std::string list_text(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", number_text(v.x()), number_text(v.y()), number_text(v.z()));
}

}  // namespace

std::vector<double> variable_inputs(const VariableSpec& variable, std::span<const double> shares) {
  if (variable.distribution == Distribution::uniform_attitude)
    return {360.0 * shares[0] - 180.0, degrees_of(std::asin(2.0 * shares[1] - 1.0)),
            360.0 * shares[2] - 180.0};
  if (variable.distribution == Distribution::cone) {
    // 1 - cos = 2 sin^2(half) keeps the digits of small angles.
    const double half = std::sin(0.5 * radians_of(variable.half_angle_deg));
    return {degrees_of(2.0 * std::asin(half * std::sqrt(shares[0]))), 360.0 * shares[1]};
  }
  return {quantile(variable, shares[0])};
}

std::string variable_value(const VariableSpec& variable, std::span<const double> inputs) {
  if (variable.distribution == Distribution::uniform_attitude)
    return list_text(rotation_vector_deg(attitude(inputs)));
  if (variable.distribution == Distribution::cone)
    return list_text(variable.length * direction(variable, inputs));
  const double value = inputs[0];
  // Whole numbers of a list also suit keys that take integers.
  const bool whole = variable.distribution == Distribution::values && value == std::floor(value) &&
                     std::abs(value) < 0x1.0p53;
  return whole ? fmt::format("{}", static_cast<long long>(value)) : number_text(value);
}

}  // namespace retiarius

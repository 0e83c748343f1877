#include "retiarius/record/body_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace retiarius {

namespace {

double net_width(const Network& network) {
  if (network.design.empty()) return 1.0;
  Vec3 low = network.design[0], high = low;
  for (const Vec3& x : network.design) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

}  // namespace

TriangleMesh drawn_mesh(const Body& body, const Network& network) {
  if (body.kind != ShapeKind::plane) return body.shape->triangles();
  const double half = net_width(network);
  TriangleMesh square;
  square.vertices = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  return square;
}

double steel_ball_radius(double mass) {
  constexpr double kSteel = 7850.0;  // kg/m3
  return std::cbrt(3.0 * mass / (4.0 * kPi * kSteel));
}

std::string file_name_of(const std::string& name) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.";
  std::string safe = name;
  std::replace_if(
      safe.begin(), safe.end(), [&](char c) { return kAllowed.find(c) == std::string_view::npos; },
      '_');
  return safe;
}

}  // namespace retiarius

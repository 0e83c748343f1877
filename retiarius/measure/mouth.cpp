#include "retiarius/measure/mouth.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {

std::vector<Vec3> polygon(const std::vector<Vec3>& x, const std::vector<Index>& nodes) {
  std::vector<Vec3> corners;
  corners.reserve(nodes.size());
  for (const Index i : nodes) corners.push_back(x[i]);
  return corners;
}

// Measured from the first corner, so that a mouth far from the origin loses no digits.
Vec3 area_vector(const std::vector<Vec3>& corners) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]);
  return 0.5 * sum;
}

double projected_area(const std::vector<Vec3>& corners, const Vec3& normal) {
  return std::abs(area_vector(corners).dot(normal));
}

double width(const std::vector<Vec3>& corners) {
  double largest = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      largest = std::max(largest, (corners[i] - corners[j]).squaredNorm());
  return std::sqrt(largest);
}

}  // namespace retiarius

#include "retiarius/mission/grips.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

Index nearest_knot(const Network& network, const Vec3& point) {
  Index best = kNone;
  double least = kInfinity;
  for (Index k : network.knots) {
    const double d = (network.design[k] - point).squaredNorm();
    if (d < least) {
      least = d;
      best = k;
    }
  }
  return best;
}

std::vector<Vec3> lattice_points(const Network& network, double spacing, bool lines_only) {
  std::vector<Vec3> points;
  const std::size_t corners = network.corners.size();
  const Vec3 center = network.design[network.center];
  for (std::size_t k = 0; k < corners; ++k) {
    const Vec3 a = network.design[network.corners[k]] - center;
    const Vec3 b = network.design[network.corners[(k + 1) % corners]] - center;
    const int count = std::max(1, static_cast<int>(std::lround(a.norm() / spacing)));
    for (int i = 0; i <= count; ++i) {
      for (int j = 0; i + j <= count; ++j) {
        if (lines_only && i != 0 && j != 0 && i + j != count) continue;
        points.push_back(center + (i * a + j * b) / count);
      }
    }
  }
  return points;
}

}  // namespace

std::vector<Index> choose_grips(const PhaseSpec& phase, const Network& network) {
  std::vector<Index> grips = network.bullets;
  for (const std::string& name : phase.grips) {
    if (name == "lattice" || name == "spokes") {
      if (network.corners.size() < 3)
        throw InputError(phase.place, fmt::format("phase \"{}\", grips = \"{}\": the net has no "
                                                  "outline with corners; name the grips instead",
                                                  phase.name, name));
      for (const Vec3& p : lattice_points(network, phase.grip_spacing, name == "spokes"))
        grips.push_back(nearest_knot(network, p));
    } else {
      const std::vector<Index> named = select_nodes(network, name);
      grips.insert(grips.end(), named.begin(), named.end());
    }
  }
  std::sort(grips.begin(), grips.end());
  grips.erase(std::unique(grips.begin(), grips.end()), grips.end());
  return grips;
}

}  // namespace retiarius

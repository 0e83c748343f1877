#include "retiarius/contact/around_revolved.hpp"

#include <algorithm>
#include <cmath>

namespace retiarius {
namespace {

constexpr int kFewest = 12, kMost = 2048;

// The corners of a polygon around a circle lie radius (1 / cos(pi / n) - 1) outside it.
int sectors_for(double radius, double chord_error) {
  const double half_angle = std::acos(radius / (radius + chord_error));
  if (!(half_angle > kPi / kMost)) return kMost;
  return std::clamp(static_cast<int>(std::ceil(kPi / half_angle)), kFewest, kMost);
}

class Builder {
 public:
  Builder(double radius, int sectors) : radius_(radius / std::cos(kPi / sectors)), n_(sectors) {}

  Index add_ring(double z) {
    const auto first = static_cast<Index>(mesh_.vertices.size());
    for (int k = 0; k < n_; ++k) {
      const double angle = 2.0 * kPi * k / n_;
      mesh_.vertices.emplace_back(radius_ * std::cos(angle), radius_ * std::sin(angle), z);
    }
    return first;
  }

  // Joins a ring to the point of the axis at z, seen from above (or below).
  void add_fan(Index ring, double z, bool seen_from_above) {
    const auto center = static_cast<Index>(mesh_.vertices.size());
    mesh_.vertices.emplace_back(0.0, 0.0, z);
    for (int k = 0; k < n_; ++k) {
      const Index a = ring + k, b = ring + (k + 1) % n_;
      if (seen_from_above) {
        mesh_.triangles.push_back({center, a, b});
      } else {
        mesh_.triangles.push_back({center, b, a});
      }
    }
  }

  void add_side(Index low, Index high) {
    for (int k = 0; k < n_; ++k) {
      const int next = (k + 1) % n_;
      mesh_.triangles.push_back({low + k, low + next, high + next});
      mesh_.triangles.push_back({low + k, high + next, high + k});
    }
  }

  TriangleMesh take() { return std::move(mesh_); }

 private:
  double radius_;
  int n_;
  TriangleMesh mesh_;
};

}  // namespace

double revolved_radius(const TriangleMesh& surface) {
  double radius = 0.0;
  for (const Vec3& p : surface.vertices) radius = std::max(radius, std::hypot(p.x(), p.y()));
  return radius;
}

TriangleMesh around_revolved(const Body& body, double chord_error) {
  const TriangleMesh drawn = body.shape->triangles();
  double bottom = kInfinity, top = -kInfinity;
  for (const Vec3& p : drawn.vertices) {
    bottom = std::min(bottom, p.z());
    top = std::max(top, p.z());
  }
  const double radius = revolved_radius(drawn);
  Builder builder(radius, sectors_for(radius, chord_error));
  const Index low = builder.add_ring(bottom);
  if (body.kind == ShapeKind::cylinder) {
    const Index high = builder.add_ring(top);
    builder.add_side(low, high);
    builder.add_fan(high, top, true);
  } else {
    builder.add_fan(low, top, true);
  }
  builder.add_fan(low, bottom, false);
  return builder.take();
}

}  // namespace retiarius

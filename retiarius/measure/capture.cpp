#include "retiarius/measure/capture.hpp"

namespace retiarius {

namespace {

// Whether the box around the nodes comes near enough to hold anything of the target. A net on its
// way does not, and needs no hull.
bool reaches(const Body& target, const BodyState& pose, const std::vector<Vec3>& nodes) {
  const double radius = target.shape->bounding_radius();
  Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
  for (const Vec3& x : nodes) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return ((pose.position.array() + radius >= low.array()) &&
          (pose.position.array() - radius <= high.array()))
      .all();
}

}  // namespace

std::optional<Capture> measure_capture(const Body& target, const BodyState& pose,
                                       const std::vector<Vec3>& nodes) {
  if (target.kind == ShapeKind::plane) return std::nullopt;
  if (!reaches(target, pose, nodes)) return Capture{};
  return measure_capture(target, pose, nodes, convex_hull(nodes));
}

std::optional<Capture> measure_capture(const Body& target, const BodyState& pose,
                                       const std::vector<Vec3>& nodes,
                                       const std::optional<ConvexHull>& hull) {
  if (target.kind == ShapeKind::plane) return std::nullopt;
  if (!hull || !reaches(target, pose, nodes)) return Capture{};
  return Capture{captured_share(target.shape->triangles(), pose, *hull),
                 hull->contains(pose.position)};
}

}  // namespace retiarius

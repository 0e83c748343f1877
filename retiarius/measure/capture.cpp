#include "retiarius/measure/capture.hpp"

#include "retiarius/measure/hull.hpp"

namespace retiarius {

std::optional<Capture> measure_capture(const Body& target, const BodyState& pose,
                                       const std::vector<Vec3>& nodes) {
  if (target.kind == ShapeKind::plane) return std::nullopt;
  const std::optional<ConvexHull> hull = convex_hull(nodes);
  if (!hull) return Capture{};
  return Capture{captured_share(target.shape->triangles(), pose, *hull),
                 hull->contains(pose.position)};
}

}  // namespace retiarius

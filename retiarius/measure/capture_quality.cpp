#include "retiarius/measure/capture_quality.hpp"

#include <algorithm>
#include <cmath>

#include "retiarius/base/error.hpp"

namespace retiarius {

namespace {

constexpr double kWindow = 0.5;     // s, over which the settled value is the mean
constexpr double kBand = 0.05;      // of the settled value
constexpr double kRounding = 1e-9;  // s, of times that are products

}  // namespace

std::optional<QualityScale> quality_scale(const Body& target) {
  if (target.kind == ShapeKind::plane) return std::nullopt;
  const double length = 2.0 * target.shape->bounding_radius();
  if (target.kind != ShapeKind::mesh)
    return QualityScale{target.shape->solid().volume, target.shape->surface_area(), length};
  const std::optional<ConvexHull> hull = convex_hull(target.shape->triangles().vertices);
  if (!hull) return std::nullopt;
  return QualityScale{hull->volume, hull->area, length};
}

double flat_hull_area(const std::vector<Vec3>& points) {
  if (points.size() < 3) return 0.0;
  // Axes in the plane: towards the farthest point from the first, and across to the farthest of
  // the rest.
  const Vec3& origin = points.front();
  Vec3 along = Vec3::Zero();
  for (const Vec3& p : points)
    if ((p - origin).squaredNorm() > along.squaredNorm()) along = p - origin;
  if (along.isZero(0.0)) return 0.0;
  along.normalize();
  const auto across_of = [&](const Vec3& p) -> Vec3 {
    return (p - origin) - (p - origin).dot(along) * along;
  };
  Vec3 across = Vec3::Zero();
  for (const Vec3& p : points)
    if (across_of(p).squaredNorm() > across.squaredNorm()) across = across_of(p);
  if (across.isZero(0.0)) return 0.0;
  across.normalize();

  std::vector<Eigen::Vector2d> flat;
  flat.reserve(points.size());
  for (const Vec3& p : points) flat.emplace_back((p - origin).dot(along), (p - origin).dot(across));
  std::sort(flat.begin(), flat.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  // Lower and upper chain (Andrew, Inf. Process. Lett. 9, 1979), the area as it goes.
  const auto turn = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                       const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  };
  double doubled = 0.0;
  for (int side = 0; side < 2; ++side) {
    std::vector<Eigen::Vector2d> chain;
    for (const Eigen::Vector2d& p : flat) {
      while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0.0)
        chain.pop_back();
      chain.push_back(p);
    }
    for (std::size_t k = 1; k < chain.size(); ++k)
      doubled += chain[k - 1].x() * chain[k].y() - chain[k - 1].y() * chain[k].x();
    std::reverse(flat.begin(), flat.end());
  }
  return 0.5 * std::abs(doubled);
}

double capture_quality(const QualityScale& target, const Vec3& target_center,
                       const std::vector<Vec3>& nodes, const std::vector<double>& mass,
                       const std::optional<ConvexHull>& hull) {
  Vec3 moment = Vec3::Zero();
  double total = 0.0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    moment += mass[k] * (nodes[k] - target_center);
    total += mass[k];
  }
  const double volume = hull ? hull->volume : 0.0;
  const double area = hull ? hull->area : 2.0 * flat_hull_area(nodes);
  return 0.1 * std::abs(volume - target.volume) / target.volume +
         0.1 * std::abs(area - target.area) / target.area +
         0.8 * (moment / total).norm() / target.length;
}

void Settling::see(double time, double value) {
  if (!samples_.empty() && samples_.back().first == time) samples_.pop_back();
  samples_.emplace_back(time, value);
}

std::optional<std::pair<double, std::size_t>> Settling::settled() const {
  if (samples_.empty()) return std::nullopt;
  const double start = samples_.back().first - kWindow - kRounding;
  if (samples_.front().first > start + 2.0 * kRounding) return std::nullopt;
  std::size_t count = 0;
  double sum = 0.0;
  for (auto s = samples_.rbegin(); s != samples_.rend() && s->first >= start; ++s, ++count)
    sum += s->second;
  const double value = sum / static_cast<double>(count);
  std::size_t first = samples_.size();
  while (first > 0 && std::abs(samples_[first - 1].second - value) <= kBand * std::abs(value))
    --first;
  if (samples_.size() - first < count) return std::nullopt;
  return std::pair{value, first};
}

std::optional<double> Settling::value() const {
  const auto found = settled();
  return found ? std::optional(found->first) : std::nullopt;
}

std::optional<double> Settling::time() const {
  const auto found = settled();
  return found ? std::optional(samples_[found->second].first) : std::nullopt;
}

void Settling::transfer(Archive& archive) {
  std::vector<double> times, values;
  for (const auto& [time, value] : samples_) {
    times.push_back(time);
    values.push_back(value);
  }
  archive(times, values);
  if (times.size() != values.size()) throw Error("as many times as values are needed");
  samples_.clear();
  for (std::size_t k = 0; k < times.size(); ++k) samples_.emplace_back(times[k], values[k]);
}

}  // namespace retiarius

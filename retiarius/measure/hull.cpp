#include "retiarius/measure/hull.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include <Eigen/Eigenvalues>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "retiarius/base/error.hpp"
#include "retiarius/bodies/body.hpp"

namespace retiarius {
namespace {

// A file in memory that takes what qhull prints.
class Printed {
 public:
  Printed() : file_(open_memstream(&text_, &size_)) {
    if (file_ == nullptr) throw RunError("no memory for qhull's messages");
  }
  Printed(const Printed&) = delete;
  Printed& operator=(const Printed&) = delete;
  ~Printed() {
    std::fclose(file_);
    std::free(text_);
  }
  FILE* file() { return file_; }
  std::string first_line() {
    std::fflush(file_);
    const std::string text(text_, size_);
    return text.substr(0, text.find('\n'));
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  FILE* file_;
};

// One run of qhull; owns the memory of its reentrant state.
class Quickhull {
 public:
  Quickhull() : qh_(std::make_unique<qhT>()) { qh_zero(qh_.get(), printed_.file()); }
  Quickhull(const Quickhull&) = delete;
  Quickhull& operator=(const Quickhull&) = delete;
  ~Quickhull() {
    int long_blocks = 0, long_bytes = 0;
    qh_freeqhull(qh_.get(), !qh_ALL);
    qh_memfreeshort(qh_.get(), &long_blocks, &long_bytes);
  }

  // Returns qhull's exit code. The options' text may not be const for qhull.
  int run(std::vector<double>& coordinates, std::string options) {
    return qh_new_qhull(qh_.get(), 3, static_cast<int>(coordinates.size() / 3), coordinates.data(),
                        False, options.data(), nullptr, printed_.file());
  }

  ConvexHull take() {
    qhT* qh = qh_.get();  // the name that qhull's macros expect
    ConvexHull hull;
    facetT* facet = nullptr;
    FORALLfacets { hull.planes.push_back({Vec3(facet->normal), facet->offset}); }
    qh_getarea(qh, qh->facet_list);
    hull.volume = qh->totvol;
    hull.area = qh->totarea;
    return hull;
  }

  std::string message() { return printed_.first_line(); }

 private:
  Printed printed_;
  std::unique_ptr<qhT> qh_;
};

using Polygon = std::vector<Vec3>;

// The part of a convex polygon on the inner side of a plane (Sutherland & Hodgman 1974).
void clip(Polygon& polygon, const ConvexHull::Plane& plane, Polygon& kept) {
  kept.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3& here = polygon[k];
    const Vec3& next = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    const double h0 = plane.normal.dot(here) + plane.offset;
    const double h1 = plane.normal.dot(next) + plane.offset;
    if (h0 <= 0.0) kept.push_back(here);
    if ((h0 <= 0.0) != (h1 <= 0.0)) kept.push_back(here + h0 / (h0 - h1) * (next - here));
  }
  polygon.swap(kept);
}

double area(const Polygon& polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    sum += (polygon[k - 1] - polygon[0]).cross(polygon[k] - polygon[0]);
  }
  return 0.5 * sum.norm();
}

// The area of what all planes leave of a polygon; both are used up. Most planes do not come near a
// ball around it, and need no clipping.
double clipped_area(Polygon& polygon, const std::vector<ConvexHull::Plane>& planes, Polygon& kept) {
  Vec3 center = Vec3::Zero();
  for (const Vec3& p : polygon) center += p / static_cast<double>(polygon.size());
  double reach = 0.0;
  for (const Vec3& p : polygon) reach = std::max(reach, (p - center).norm());
  for (const auto& plane : planes) {
    const double height = plane.normal.dot(center) + plane.offset;
    if (height < -1.001 * reach) continue;
    if (height > 1.001 * reach) return 0.0;
    clip(polygon, plane, kept);
    if (polygon.size() < 3) return 0.0;
  }
  return area(polygon);
}

// Of a net that is flatter than this over its size, qhull may find that its facets cannot be told
// from each other.
constexpr double kFlat = 1e-3;

// Extent of the points along the direction in which they are thinnest, m. x, y, z of each in a row,
// about their mean.
double thickness(const std::vector<double>& coordinates) {
  const Eigen::Map<const Eigen::Matrix3Xd> points(
      coordinates.data(), 3, static_cast<Eigen::Index>(coordinates.size() / 3));
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(points * points.transpose());
  const Eigen::RowVectorXd along = axes.eigenvectors().col(0).transpose() * points;
  return along.maxCoeff() - along.minCoeff();
}

}  // namespace

bool ConvexHull::contains(const Vec3& point) const {
  return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
    return plane.normal.dot(point) + plane.offset <= tolerance;
  });
}

std::optional<ConvexHull> convex_hull(const std::vector<Vec3>& points) {
  if (points.size() < 4) return std::nullopt;
  // About the mean, so that rounding is that of the net's size and not of its place.
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : points) mean += p / static_cast<double>(points.size());
  if (!mean.allFinite()) throw RunError("the convex hull needs points that are finite");
  std::vector<double> coordinates;
  double size = 0.0;
  for (const Vec3& p : points) {
    const Vec3 q = p - mean;
    size = std::max(size, q.norm());
    coordinates.insert(coordinates.end(), q.begin(), q.end());
  }
  if (size <= 1e-12 * mean.norm()) return std::nullopt;  // one point but for rounding
  const std::vector<double> original = coordinates;      // qhull may change what it is given
  Quickhull quickhull;
  const int code = quickhull.run(coordinates, "qhull Pp");
  if (code == qh_ERRsingular) return std::nullopt;
  if (code != qh_ERRnone && thickness(original) <= kFlat * size) return std::nullopt;
  if (code != qh_ERRnone) throw RunError("the convex hull failed: " + quickhull.message());
  ConvexHull hull = quickhull.take();
  for (auto& plane : hull.planes) plane.offset -= plane.normal.dot(mean);
  hull.tolerance = 1e-10 * size;
  return hull;
}

double captured_share(const TriangleMesh& surface, const BodyState& pose, const ConvexHull& hull) {
  std::vector<Vec3> world;
  world.reserve(surface.vertices.size());
  std::vector<bool> held;
  for (const Vec3& p : surface.vertices) {
    world.push_back(to_world(pose, p));
    held.push_back(hull.contains(world.back()));
  }
  double total = 0.0, inside = 0.0;
  Polygon polygon, kept;
  for (const auto& triangle : surface.triangles) {
    polygon.clear();
    for (const Index v : triangle) polygon.push_back(world[static_cast<std::size_t>(v)]);
    const double whole = area(polygon);
    total += whole;
    // The hull is convex: it holds a triangle whose corners it holds.
    if (std::all_of(triangle.begin(), triangle.end(),
                    [&](Index v) { return held[static_cast<std::size_t>(v)]; })) {
      inside += whole;
      continue;
    }
    inside += clipped_area(polygon, hull.planes, kept);
  }
  return inside / total;
}

}  // namespace retiarius

#include "retiarius/check/checked_solid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "retiarius/check/plain_distance.hpp"

namespace retiarius::check {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

// Signed distance from (x, y) to the corner region x <= 0, y <= 0.
double to_quadrant(double x, double y) {
  return std::min(std::max(x, y), 0.0) + std::hypot(std::max(x, 0.0), std::max(y, 0.0));
}

double to_box(const Vec3& p, const Vec3& size) {
  const Vec3 beyond = p.cwiseAbs() - 0.5 * size;
  return std::min(beyond.maxCoeff(), 0.0) + beyond.cwiseMax(0.0).norm();
}

double to_cylinder(const Vec3& p, double radius, double length) {
  return to_quadrant(std::hypot(p.x(), p.y()) - radius, std::abs(p.z()) - 0.5 * length);
}

double to_capsule(const Vec3& p, double radius, double length) {
  const double beyond = std::max(std::abs(p.z()) - 0.5 * length, 0.0);
  return std::hypot(std::hypot(p.x(), p.y()), beyond) - radius;
}

// Base at z = -length / 4, apex at z = 3/4 length: the mass centre is the origin.
double to_cone(const Vec3& p, double radius, double length) {
  const Vec3 place(std::hypot(p.x(), p.y()), 0.0, p.z());
  const Vec3 rim(radius, 0.0, -0.25 * length), apex(0.0, 0.0, 0.75 * length);
  const Vec3 axis(0.0, 0.0, -0.25 * length);
  const double slant = std::hypot(radius, length);
  const double above_side =
      (length * (place.x() - rim.x()) + radius * (place.z() - rim.z())) / slant;
  const double below_base = axis.z() - place.z();
  if (above_side <= 0.0 && below_base <= 0.0) return std::max(above_side, below_base);
  return std::min(point_segment(place, rim, apex), point_segment(place, axis, rim));
}

// A convex body: its signed distance is a convex function.
class Convex final : public CheckedSolid {
 public:
  Convex(double radius, std::function<double(const Vec3&)> distance)
      : radius_(radius), distance_(std::move(distance)) {}

  double radius() const override { return radius_; }

  double distance(const Vec3& a, const Vec3& b, double enough) const override {
    const double rough = distance_(0.5 * (a + b)) - 0.5 * (b - a).norm();
    if (rough >= enough) return rough;
    return smallest([&](double s) { return distance_(a + s * (b - a)); });
  }

  Near near(const Vec3&, const Vec3&) const override { return {}; }
  double distance(const Near&, const Vec3& a, const Vec3& b, double enough) const override {
    return distance(a, b, enough);
  }

 private:
  // Of a convex function on [0, 1], by cutting off a third at a time.
  static double smallest(const std::function<double(double)>& f) {
    double low = 0.0, high = 1.0;
    double least = std::min(f(0.0), f(1.0));
    for (int k = 0; k < 90; ++k) {
      const double s = low + (high - low) / 3.0, t = high - (high - low) / 3.0;
      const double fs = f(s), ft = f(t);
      least = std::min({least, fs, ft});
      if (fs < ft) {
        high = t;
      } else {
        low = s;
      }
    }
    return least;
  }

  double radius_;
  std::function<double(const Vec3&)> distance_;
};

// A closed surface of triangles.
class Surface final : public CheckedSolid {
 public:
  explicit Surface(const TriangleMesh& mesh) {
    for (const auto& t : mesh.triangles) {
      triangles_.push_back(
          {mesh.vertices[at(t[0])], mesh.vertices[at(t[1])], mesh.vertices[at(t[2])]});
      const Triangle& corners = triangles_.back();
      turned_.push_back(
          {oddly_turned() * corners[0], oddly_turned() * corners[1], oddly_turned() * corners[2]});
      low_.push_back(corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]));
      high_.push_back(corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]));
      all_.triangles.push_back(static_cast<Index>(all_.triangles.size()));
    }
    for (const Vec3& p : mesh.vertices) {
      radius_ = std::max(radius_, p.norm());
      bottom_ = bottom_.cwiseMin(p);
      top_ = top_.cwiseMax(p);
    }
  }

  double radius() const override { return radius_; }

  double distance(const Vec3& a, const Vec3& b, double enough) const override {
    const double outside = distance(all_, a, b, enough);
    // Farther from the surface than `enough` the first end tells the side of all.
    return outside >= enough && is_inside(a) ? -depth(a) : outside;
  }

  Near near(const Vec3& low, const Vec3& high) const override {
    Near found;
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
      if ((low_[k].array() <= high.array()).all() && (high_[k].array() >= low.array()).all())
        found.triangles.push_back(static_cast<Index>(k));
    }
    found.nothing = found.triangles.empty();
    return found;
  }

  double distance(const Near& near, const Vec3& a, const Vec3& b, double enough) const override {
    const double reach = std::max(enough, 0.0);
    const Vec3 low = a.cwiseMin(b).array() - reach, high = a.cwiseMax(b).array() + reach;
    double least = kInfinity;
    for (const Index k : near.triangles) {
      if (!((low_[at(k)].array() <= high.array()).all() &&
            (high_[at(k)].array() >= low.array()).all()))
        continue;
      least = std::min(least, segment_triangle(a, b, triangles_[at(k)]));
    }
    return least >= enough ? least : std::min(least, -deepest(a, b));
  }

 private:
  // A ray in an odd direction meets the surface an odd number of times from inside; where it seems
  // so, the solid angles decide.
  bool is_inside(const Vec3& p) const {
    if (!((bottom_.array() < p.array()).all() && (p.array() < top_.array()).all())) return false;
    const Vec3 q = oddly_turned() * p;
    bool inside = false;
    for (const Triangle& t : turned_) {
      if (std::min({t[0].y(), t[1].y(), t[2].y()}) > q.y() ||
          std::max({t[0].y(), t[1].y(), t[2].y()}) < q.y() ||
          std::min({t[0].z(), t[1].z(), t[2].z()}) > q.z() ||
          std::max({t[0].z(), t[1].z(), t[2].z()}) < q.z())
        continue;
      if (ray_meets(q, t)) inside = !inside;
    }
    return inside && winding_number(p, triangles_) > 0.5;
  }

  // Whether the ray from q along x meets the triangle.
  static bool ray_meets(const Vec3& q, const Triangle& t) {
    int sign = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 side = t[(k + 1) % 3] - t[k], away = q - t[k];
      const int here = side.y() * away.z() - side.z() * away.y() < 0.0 ? -1 : 1;
      if (sign != 0 && here != sign) return false;
      sign = here;
    }
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    return normal.x() != 0.0 && normal.dot(t[0] - q) / normal.x() > 0.0;
  }

  // Turns no axis or diagonal of a drawing into another.
  static const Mat3& oddly_turned() {
    static const Mat3 turn =
        Eigen::AngleAxisd(1.2345, Vec3(0.267, 0.535, 0.802).normalized()).toRotationMatrix();
    return turn;
  }

  double depth(const Vec3& p) const {
    double least = kInfinity;
    for (const Triangle& t : triangles_) least = std::min(least, point_triangle(p, t));
    return least;
  }

  // The largest depth of the places inside; minus infinity where none is.
  double deepest(const Vec3& a, const Vec3& b) const {
    constexpr int kPlaces = 32;
    double most = -kInfinity;
    for (int k = 0; k <= kPlaces; ++k) {
      const Vec3 p = a + k / double(kPlaces) * (b - a);
      if (is_inside(p)) most = std::max(most, depth(p));
    }
    return most;
  }

  std::vector<Triangle> triangles_;
  std::vector<Triangle> turned_;
  std::vector<Vec3> low_, high_;  // of each triangle
  Near all_;
  double radius_ = 0.0;
  Vec3 bottom_ = Vec3::Constant(kInfinity), top_ = Vec3::Constant(-kInfinity);
};

}  // namespace

std::unique_ptr<CheckedSolid> checked_solid(const BodySpec& spec, const TriangleMesh& recorded) {
  const double r = spec.radius, l = spec.length;
  const Vec3 size = spec.size;
  const auto convex = [](double radius, std::function<double(const Vec3&)> distance) {
    return std::make_unique<Convex>(radius, std::move(distance));
  };
  switch (spec.shape) {
    case ShapeKind::sphere:
      return convex(r, [r](const Vec3& p) { return p.norm() - r; });
    case ShapeKind::box:
      return convex(0.5 * size.norm(), [size](const Vec3& p) { return to_box(p, size); });
    case ShapeKind::cylinder:
      return convex(std::hypot(r, 0.5 * l), [r, l](const Vec3& p) { return to_cylinder(p, r, l); });
    case ShapeKind::capsule:
      return convex(r + 0.5 * l, [r, l](const Vec3& p) { return to_capsule(p, r, l); });
    case ShapeKind::cone:
      return convex(std::max(0.75 * l, std::hypot(r, 0.25 * l)),
                    [r, l](const Vec3& p) { return to_cone(p, r, l); });
    case ShapeKind::plane:
      return convex(kInfinity, [](const Vec3& p) { return p.z(); });
    case ShapeKind::mesh:
      break;
  }
  return std::make_unique<Surface>(recorded);
}

}  // namespace retiarius::check

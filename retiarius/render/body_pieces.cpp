// Bodies as lit triangles, cut small enough to be sorted by depth and shaded smoothly.
#include <algorithm>
#include <map>

#include "retiarius/render/painter.hpp"

namespace retiarius::render {

namespace {

constexpr double kCrease = 0.8;        // cosine of the angle above which an edge is sharp
constexpr double kFlatPiece = 24.0;    // longest side on paper of a piece of a flat surface
constexpr double kCurvedPiece = 11.0;  // of a curved one
constexpr int kDeepest = 6;            // halvings at most

struct Corner {
  Vec3 x, normal;
};

Colour tint(std::size_t body) {
  static constexpr Colour kTints[] = {
      {0.83, 0.79, 0.70}, {0.70, 0.77, 0.83}, {0.78, 0.74, 0.82}, {0.75, 0.81, 0.74}};
  return kTints[body % std::size(kTints)];
}

Colour lit(const Colour& tint, const Vec3& normal, const Vec3& x, const Camera& camera) {
  const double facing = normal.dot(camera.towards(x)) < 0.0 ? -1.0 : 1.0;
  const double diffuse = std::max(0.0, facing * normal.dot(camera.lamp()));
  // What the lamp leaves dark gets a weaker light from the other side.
  const Vec3 other = (camera.towards(x) + 0.8 * camera.right() - 0.9 * camera.up()).normalized();
  const double fill = std::max(0.0, facing * normal.dot(other));
  const Vec3 half = (camera.lamp() + camera.towards(x)).normalized();
  const double shine = std::pow(std::max(0.0, facing * normal.dot(half)), 24.0);
  const Colour shaded = mixed({0.20, 0.22, 0.28}, tint, 0.3 + 0.7 * diffuse + 0.26 * fill);
  return mixed(shaded, {1.0, 1.0, 1.0}, 0.28 * shine);
}

// One body's surface in the world, with which triangles meet at each edge.
class Surface {
 public:
  Surface(const TriangleMesh& mesh, const BodyState& pose) : triangles_(mesh.triangles) {
    for (const Vec3& x : mesh.vertices) x_.push_back(to_world(pose, x));
    normals_.reserve(triangles_.size());
    at_.resize(x_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const auto& [a, b, c] = triangles_[t];
      normals_.push_back((at(b) - at(a)).cross(at(c) - at(a)).normalized());
      for (std::size_t k = 0; k < 3; ++k) {
        const Index from = triangles_[t][k], to = triangles_[t][(k + 1) % 3];
        edges_[std::minmax(from, to)].push_back(t);
        at_[static_cast<std::size_t>(from)].push_back(t);
      }
    }
  }

  std::size_t size() const { return triangles_.size(); }
  const Vec3& normal(std::size_t t) const { return normals_[t]; }
  const Vec3& at(Index node) const { return x_[static_cast<std::size_t>(node)]; }
  const auto& edges() const { return edges_; }

  Vec3 centre() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& x : x_) sum += x / static_cast<double>(x_.size());
    return sum;
  }

  // Corners with the mean normal of the triangles that go on smoothly from this one.
  std::array<Corner, 3> corners(std::size_t t) const {
    std::array<Corner, 3> list;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index node = triangles_[t][k];
      Vec3 sum = Vec3::Zero();
      for (std::size_t other : at_[static_cast<std::size_t>(node)])
        if (normals_[other].dot(normals_[t]) > kCrease) sum += normals_[other];
      list[k] = {at(node), sum.normalized()};
    }
    return list;
  }

 private:
  std::vector<std::array<Index, 3>> triangles_;
  std::vector<Vec3> x_, normals_;
  std::vector<std::vector<std::size_t>> at_;  // triangles at each vertex
  std::map<std::pair<Index, Index>, std::vector<std::size_t>> edges_;
};

double longest_side(const std::array<Place, 3>& p) {
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, std::hypot(p[k].x - p[(k + 1) % 3].x, p[k].y - p[(k + 1) % 3].y));
  return longest;
}

class Cutter {
 public:
  Cutter(const Camera& camera, std::vector<SurfacePiece>& pieces)
      : camera_(camera), pieces_(pieces) {}

  // A flat piece takes its light where `flat_at` is, so that a face has one colour.
  void add(const std::array<Corner, 3>& c, const Colour& tint, const Vec3* flat_at, int deepest) {
    const double limit = flat_at ? kFlatPiece : kCurvedPiece;
    const std::array<Place, 3> places = {camera_.place(c[0].x), camera_.place(c[1].x),
                                         camera_.place(c[2].x)};
    if (deepest > 0 && longest_side(places) > limit) {
      const auto middle = [](const Corner& a, const Corner& b) {
        return Corner{0.5 * (a.x + b.x), (a.normal + b.normal).normalized()};
      };
      const Corner ab = middle(c[0], c[1]), bc = middle(c[1], c[2]), ca = middle(c[2], c[0]);
      add({c[0], ab, ca}, tint, flat_at, deepest - 1);
      add({ab, c[1], bc}, tint, flat_at, deepest - 1);
      add({ca, bc, c[2]}, tint, flat_at, deepest - 1);
      add({ab, bc, ca}, tint, flat_at, deepest - 1);
      return;
    }
    const Vec3 x = (c[0].x + c[1].x + c[2].x) / 3.0;
    const Vec3 normal = (c[0].normal + c[1].normal + c[2].normal).normalized();
    pieces_.push_back(
        {places, 3, camera_.place(x).depth, lit(tint, normal, flat_at ? *flat_at : x, camera_)});
  }

  // A sharp edge or the outline, cut like a thread.
  void add_edge(const Vec3& a, const Vec3& b, const Colour& colour) {
    const Place from = camera_.place(a), to = camera_.place(b);
    const int count =
        std::max(1, static_cast<int>(std::hypot(from.x - to.x, from.y - to.y) / kCurvedPiece));
    for (int k = 0; k < count; ++k) {
      const Vec3 p = a + (b - a) * k / count, q = a + (b - a) * (k + 1) / count;
      // Nearer by half a piece: an edge lies on the pieces that it borders.
      const double nearer = 0.5 * kFlatPiece / camera_.middle_scale();
      pieces_.push_back({{camera_.place(p), camera_.place(q), {}},
                         2,
                         camera_.place(0.5 * (p + q)).depth - nearer,
                         colour});
    }
  }

 private:
  const Camera& camera_;
  std::vector<SurfacePiece>& pieces_;
};

void add_body(const Surface& surface, const Colour& tint, const Camera& camera, DepthMap& depths,
              std::vector<SurfacePiece>& pieces) {
  const Vec3 centre = surface.centre();
  Cutter cutter(camera, pieces);
  const bool open = surface.size() <= 2;  // a plane is seen from both sides
  std::vector<bool> seen(surface.size());
  for (std::size_t t = 0; t < surface.size(); ++t) {
    const auto corners = surface.corners(t);
    seen[t] = open || surface.normal(t).dot(camera.towards(corners[0].x)) > 0.0;
    if (!seen[t]) continue;
    depths.add(
        {camera.place(corners[0].x), camera.place(corners[1].x), camera.place(corners[2].x)});
    double bend = 1.0;
    for (const Corner& c : corners) bend = std::min(bend, c.normal.dot(surface.normal(t)));
    cutter.add(corners, tint, bend < 0.999 ? nullptr : &centre, kDeepest);
  }
  const Colour line = mixed(tint, {0.14, 0.16, 0.22}, 0.62);
  for (const auto& [nodes, triangles] : surface.edges()) {
    bool visible = false, sharp = triangles.size() == 1;
    for (std::size_t t : triangles) {
      visible = visible || seen[t];
      sharp = sharp || surface.normal(t).dot(surface.normal(triangles[0])) < kCrease;
    }
    if (visible && sharp) cutter.add_edge(surface.at(nodes.first), surface.at(nodes.second), line);
  }
}

}  // namespace

std::vector<SurfacePiece> surface_pieces(const DrawnRun& run, const FrameData& frame,
                                         const Camera& camera, bool bodies, DepthMap& depths) {
  std::vector<SurfacePiece> pieces;
  for (std::size_t k = 0; k < run.bodies.size() && bodies; ++k)
    add_body(Surface(run.bodies[k].mesh, frame.bodies.at(k)), tint(k), camera, depths, pieces);
  // An edge that the map hides is left out: pieces beside it may be farther than it.
  const double tolerance = 0.01 * camera.radius();
  std::erase_if(pieces, [&](const SurfacePiece& p) {
    if (p.count != 2) return false;
    const Place middle{0.5 * (p.corner[0].x + p.corner[1].x), 0.5 * (p.corner[0].y + p.corner[1].y),
                       0.5 * (p.corner[0].depth + p.corner[1].depth), 0.0};
    return depths.hides(middle, tolerance);
  });
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const SurfacePiece& a, const SurfacePiece& b) { return a.depth > b.depth; });
  return pieces;
}

}  // namespace retiarius::render

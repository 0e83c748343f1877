#include "retiarius/contact/collision_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "retiarius/bodies/merge_vertices.hpp"
#include "retiarius/contact/around_revolved.hpp"

namespace retiarius {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

constexpr double kFlat = 1e-9;  // of the mesh's size

// The triangles at an edge: the corner opposite to it in each.
struct EdgeSides {
  std::array<Index, 2> triangle{kNone, kNone};
  std::array<Index, 2> opposite{kNone, kNone};
  int count = 0;
};

using EdgeMap = std::map<std::pair<Index, Index>, EdgeSides>;

EdgeMap edges_of(const TriangleMesh& surface) {
  EdgeMap edges;
  for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
    const auto& t = surface.triangles[k];
    for (std::size_t j = 0; j < 3; ++j) {
      const Index u = t[j], v = t[(j + 1) % 3];
      EdgeSides& sides = edges[{std::min(u, v), std::max(u, v)}];
      if (sides.count < 2) {
        sides.triangle[static_cast<std::size_t>(sides.count)] = static_cast<Index>(k);
        sides.opposite[static_cast<std::size_t>(sides.count)] = t[(j + 2) % 3];
      }
      ++sides.count;
    }
  }
  return edges;
}

// How far the far corner of one triangle lies below the plane of the other, m: the smaller of the
// two ways round. Positive where the edge is convex. The edge rises less than that above any line
// from far corner to far corner.
double rise(const TriangleMesh& surface, const EdgeSides& sides) {
  double least = kInfinity;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& t = surface.triangles[at(sides.triangle[k])];
    const Vec3& a = surface.vertices[at(t[0])];
    const Vec3 normal =
        (surface.vertices[at(t[1])] - a).cross(surface.vertices[at(t[2])] - a).normalized();
    least = std::min(least, normal.dot(a - surface.vertices[at(sides.opposite[1 - k])]));
  }
  return least;
}

void add_point(CollisionMesh& mesh, const Vec3& point, double radius) {
  mesh.points.push_back(point);
  mesh.point_radius.push_back(radius);
}

void add_edge(CollisionMesh& mesh, Index a, Index b, double radius) {
  mesh.edges.push_back({a, b});
  mesh.edge_radius.push_back(radius);
  mesh.edge_length.push_back((mesh.points[at(b)] - mesh.points[at(a)]).norm());
}

CollisionMesh sphere_mesh(double radius) {
  CollisionMesh mesh;
  add_point(mesh, Vec3::Zero(), radius);
  mesh.corners = {0};
  return mesh;
}

CollisionMesh capsule_mesh(double radius, double half) {
  CollisionMesh mesh;
  add_point(mesh, Vec3(0, 0, -half), radius);
  add_point(mesh, Vec3(0, 0, half), radius);
  add_edge(mesh, 0, 1, radius);
  mesh.corners = {0, 1};
  return mesh;
}

CollisionMesh plane_mesh() {
  CollisionMesh mesh;
  mesh.half_space = true;
  return mesh;
}

CollisionMesh shape_mesh(const Body& body, double chord_error) {
  const double bound = body.shape->bounding_radius();
  switch (body.kind) {
    case ShapeKind::sphere:
      return sphere_mesh(bound);
    case ShapeKind::plane:
      return plane_mesh();
    case ShapeKind::capsule: {
      const double radius = revolved_radius(body.shape->triangles());
      return capsule_mesh(radius, bound - radius);
    }
    case ShapeKind::cylinder:
    case ShapeKind::cone:
      return surface_collision_mesh(around_revolved(body, chord_error));
    case ShapeKind::box:
    case ShapeKind::mesh:
      break;
  }
  return surface_collision_mesh(body.shape->triangles());
}

}  // namespace

CollisionMesh surface_collision_mesh(const TriangleMesh& surface) {
  CollisionMesh mesh;
  for (const Vec3& p : surface.vertices) add_point(mesh, p, 0.0);
  mesh.triangles = surface.triangles;
  const double flat = kFlat * mesh_size(surface);
  std::vector<bool> sharp(mesh.points.size(), false);
  for (const auto& [ends, sides] : edges_of(surface)) {
    if (sides.count == 2 && rise(surface, sides) <= flat) continue;
    add_edge(mesh, ends.first, ends.second, 0.0);
    sharp[at(ends.first)] = sharp[at(ends.second)] = true;
  }
  for (Index k = 0; k < static_cast<Index>(sharp.size()); ++k)
    if (sharp[at(k)]) mesh.corners.push_back(k);
  return mesh;
}

CollisionMesh net_collision_mesh(const Network& network) {
  CollisionMesh mesh;
  for (const Vec3& p : network.design) add_point(mesh, p, 0.0);
  for (const Segment& s : network.segments) {
    const double radius = network.materials[at(s.material)].radius;
    mesh.edges.push_back({s.a, s.b});
    mesh.edge_radius.push_back(radius);
    mesh.edge_length.push_back(s.rest_length);
    for (const Index node : {s.a, s.b})
      mesh.point_radius[at(node)] = std::max(mesh.point_radius[at(node)], radius);
  }
  for (Index k = 0; k < network.node_count(); ++k) mesh.corners.push_back(k);
  return mesh;
}

CollisionMesh body_collision_mesh(const Body& body, double chord_error) {
  CollisionMesh mesh = shape_mesh(body, chord_error);
  mesh.bounding_radius = mesh.half_space ? kInfinity : 0.0;
  for (std::size_t k = 0; k < mesh.points.size(); ++k)
    mesh.bounding_radius =
        std::max(mesh.bounding_radius, mesh.points[k].norm() + mesh.point_radius[k]);
  return mesh;
}

double usual_chord_error(const Body& body, double thread_radius) {
  if (body.kind == ShapeKind::plane) return thread_radius;
  const double size = body.shape->bounding_radius();
  return std::clamp(0.25 * thread_radius, 1e-6 * size, 1e-3 * size);
}

}  // namespace retiarius

// What can touch, as rounded points, edges and triangles.
#pragma once

#include <array>
#include <vector>

#include "retiarius/base/vec.hpp"
#include "retiarius/bodies/body.hpp"
#include "retiarius/net/network.hpp"

namespace retiarius {

// The surface of the net or of one body: all places within `radius` of a point, an edge or a
// triangle. Which form a thing takes:
// - net: nodes and segments with the thread's radius;
// - sphere: one point; capsule: one edge; both with their radius;
// - box, cylinder, cone, mesh: triangles, edges and corners without radius;
// - plane: a half space, which only points touch.
struct CollisionMesh {
  std::vector<Vec3> points;  // m, body axes; of the net: as designed, for the count alone
  std::vector<std::array<Index, 2>> edges;
  std::vector<std::array<Index, 3>> triangles;  // counter-clockwise seen from outside

  // The points that act as points of their own. Of a closed surface only those at which a convex
  // edge ends: at others nothing outside touches before it touches a neighbour.
  std::vector<Index> corners;

  std::vector<double> point_radius, edge_radius;  // m
  std::vector<double> edge_length;                // m, at rest
  double bounding_radius = 0.0;                   // m, about the origin, radii included; body only
  bool half_space = false;                        // z <= 0 in body axes
};

// Nodes and segments. A point has the largest radius of its segments.
CollisionMesh net_collision_mesh(const Network& network);

// Of a body. Cylinder and cone become prisms and pyramids around them, which miss them by at most
// `chord_error` (m, positive) and never lie inside; at least 12 and at most 2048 sectors.
CollisionMesh body_collision_mesh(const Body& body, double chord_error);

// The chord error that suits threads of this radius on a body: a quarter of it, but at least 1e-6
// and at most 1e-3 of the body's bounding radius.
double usual_chord_error(const Body& body, double thread_radius);

// A closed surface as collision mesh without radius. Edges at which it is concave or flat are left
// out: a segment outside meets such an edge only where it meets a face or a convex edge as well.
// Flat: an edge that rises by less than 1e-9 of the mesh's size above its neighbours' far corners.
CollisionMesh surface_collision_mesh(const TriangleMesh& surface);

}  // namespace retiarius

#include "retiarius/contact/collision_scene.hpp"

#include <algorithm>

namespace retiarius {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

// A place of the plane and that place plus its unit normal, in body axes.
const Vec3 kPlanePlace = Vec3::Zero(), kPlaneTip = Vec3::UnitZ();

}  // namespace

std::array<PointPlace, 4> CollisionScene::places(const ContactPair& pair) const {
  std::array<PointPlace, 4> out;
  const Index a = pair.first_owner, b = pair.second_owner;
  std::size_t n = 0;
  if (pair.kind == PairKind::edge_edge) {
    for (const Index point : mesh(a).edges[at(pair.first)]) out[n++] = {a, point};
  } else {
    out[n++] = {a, pair.first};
  }
  switch (pair.kind) {
    case PairKind::point_point:
      out[n++] = {b, pair.second};
      break;
    case PairKind::point_edge:
    case PairKind::edge_edge:
      for (const Index point : mesh(b).edges[at(pair.second)]) out[n++] = {b, point};
      break;
    case PairKind::point_triangle:
      for (const Index point : mesh(b).triangles[at(pair.second)]) out[n++] = {b, point};
      break;
    case PairKind::point_plane:
      break;
  }
  return out;
}

double CollisionScene::thickness(const ContactPair& pair) const {
  const CollisionMesh &a = mesh(pair.first_owner), &b = mesh(pair.second_owner);
  const double first = pair.kind == PairKind::edge_edge ? a.edge_radius[at(pair.first)]
                                                        : a.point_radius[at(pair.first)];
  switch (pair.kind) {
    case PairKind::point_point:
      return first + b.point_radius[at(pair.second)];
    case PairKind::point_edge:
    case PairKind::edge_edge:
      return first + b.edge_radius[at(pair.second)];
    case PairKind::point_triangle:
    case PairKind::point_plane:
      break;
  }
  return first;
}

std::array<double, 2> CollisionScene::edge_lengths(const ContactPair& pair) const {
  return {mesh(pair.first_owner).edge_length[at(pair.first)],
          mesh(pair.second_owner).edge_length[at(pair.second)]};
}

PairPositions CollisionScene::positions(const ContactPair& pair, const std::vector<Vec3>& x,
                                        const std::vector<BodyState>& poses) const {
  PairPositions p{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const auto place = places(pair);
  for (std::size_t i = 0; i < static_cast<std::size_t>(point_count(pair.kind)); ++i) {
    const auto [owner, point] = place[i];
    p[i] = owner == kNet ? x[at(point)] : to_world(poses[at(owner)], mesh(owner).points[at(point)]);
  }
  if (pair.kind == PairKind::point_plane) {
    p[1] = to_world(poses[at(pair.second_owner)], kPlanePlace);
    p[2] = to_world(poses[at(pair.second_owner)], kPlaneTip);
  }
  return p;
}

PairMotion CollisionScene::motion(const ContactPair& pair, const std::vector<Vec3>& x,
                                  const std::vector<Vec3>& dx,
                                  const std::vector<BodyTwist>& twists) const {
  PairMotion motion{pair.kind, {}};
  const auto place = places(pair);
  for (std::size_t i = 0; i < static_cast<std::size_t>(point_count(pair.kind)); ++i) {
    const auto [owner, point] = place[i];
    motion.points[i] = owner == kNet
                           ? node_motion(x[at(point)], dx[at(point)])
                           : body_point_motion(twists[at(owner)], mesh(owner).points[at(point)]);
  }
  if (pair.kind == PairKind::point_plane) {
    motion.points[1] = body_point_motion(twists[at(pair.second_owner)], kPlanePlace);
    motion.points[2] = body_point_motion(twists[at(pair.second_owner)], kPlaneTip);
  }
  return motion;
}

CollisionScene make_collision_scene(const Network& network, const std::vector<Body>& bodies) {
  CollisionScene scene;
  scene.net = net_collision_mesh(network);
  double thinnest = kInfinity;
  for (const double radius : scene.net.edge_radius) thinnest = std::min(thinnest, radius);
  for (const Body& body : bodies)
    scene.bodies.push_back(body_collision_mesh(body, usual_chord_error(body, thinnest)));
  return scene;
}

}  // namespace retiarius

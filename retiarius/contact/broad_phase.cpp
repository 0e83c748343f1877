#include "retiarius/contact/broad_phase.hpp"

#include <algorithm>
#include <iterator>

#include "retiarius/contact/swept_box.hpp"

namespace retiarius {
namespace {

std::size_t at(Index k) { return static_cast<std::size_t>(k); }

Box box_of(const CollisionMesh& mesh, const std::array<Index, 2>& edge) {
  Box box(mesh.points[at(edge[0])]);
  return box.extend(mesh.points[at(edge[1])]);
}

Box box_of(const CollisionMesh& mesh, const std::array<Index, 3>& triangle) {
  Box box(mesh.points[at(triangle[0])]);
  return box.extend(mesh.points[at(triangle[1])]).extend(mesh.points[at(triangle[2])]);
}

template <class Primitives>
std::vector<Box> boxes_of(const CollisionMesh& mesh, const Primitives& primitives) {
  std::vector<Box> boxes;
  boxes.reserve(primitives.size());
  for (const auto& primitive : primitives) boxes.push_back(box_of(mesh, primitive));
  return boxes;
}

// All primitives of a body have the same radius.
double radius_of(const CollisionMesh& mesh) {
  return mesh.point_radius.empty() ? 0.0 : mesh.point_radius[0];
}

// A sphere is one point; other bodies have edges.
bool is_sphere(const CollisionMesh& mesh) { return mesh.edges.empty() && !mesh.half_space; }

}  // namespace

BroadPhase::BroadPhase(const CollisionScene& scene, const ThreadNeighbours* neighbours,
                       Options options)
    : scene_(&scene), options_(std::move(options)) {
  options_.fixed.resize(scene.bodies.size(), false);
  if (options_.self) threads_.emplace(scene.net, neighbours, options_.slack);
  trees_.resize(scene.bodies.size());
  for (std::size_t k = 0; k < trees_.size(); ++k) {
    const CollisionMesh& mesh = scene.bodies[k];
    trees_[k].edges.build(boxes_of(mesh, mesh.edges));
    trees_[k].triangles.build(boxes_of(mesh, mesh.triangles));
  }
}

PointMotion BroadPhase::node(Index k) const { return node_motion((*x_)[at(k)], (*dx_)[at(k)]); }

PointMotion BroadPhase::point(Index body, Index k) const {
  return body_point_motion((*twists_)[at(body)], scene_->bodies[at(body)].points[at(k)]);
}

// Along its way, with the segment's radius.
Box BroadPhase::segment_box(Index segment) const {
  Box box;
  for (const Index n : scene_->net.edges[at(segment)]) {
    const Vec3& start = (*x_)[at(n)];
    box.extend(start).extend(start + (*dx_)[at(n)]);
  }
  return widened(box, scene_->net.edge_radius[at(segment)]);
}

// About the bounding sphere along its way.
Box BroadPhase::body_box(Index body) const {
  const BodyTwist& twist = (*twists_)[at(body)];
  Box box(twist.position);
  box.extend(twist.position + twist.translation);
  return widened(box, scene_->bodies[at(body)].bounding_radius);
}

const std::vector<ContactPair>& BroadPhase::find(const std::vector<Vec3>& x,
                                                 const std::vector<Vec3>& dx,
                                                 const std::vector<BodyTwist>& bodies,
                                                 double margin) {
  x_ = &x;
  dx_ = &dx;
  twists_ = &bodies;
  static const Found kNoPairs;
  const Found& of_threads = threads_ ? threads_->find(x, dx, margin + options_.reach) : kNoPairs;
  parts_.clear();
  boxes_.resize(scene_->net.edges.size());
  each(boxes_.size(),
       [&](Index s, Found&) { boxes_[at(s)] = widened(segment_box(s), 0.5 * margin); });
  const auto count = bodies_left_out_ ? 0 : static_cast<Index>(scene_->bodies.size());
  for (Index k = 0; k < count; ++k) {
    if (scene_->bodies[at(k)].half_space) {
      net_on_plane(k, margin);
    } else {
      net_on_body(k, margin);
    }
    for (Index other = k + 1; other < count; ++other)
      if (!(options_.fixed[at(k)] && options_.fixed[at(other)])) body_on_body(k, other, margin);
  }
  collect(of_threads);
  return pairs_;
}

// Most nodes belong to several segments: their boxes are made once.
void BroadPhase::net_on_body(Index body, double margin) {
  Box net;
  for (const Box& box : boxes_) net.extend(box);
  if (!widened(body_box(body), margin).intersects(net)) return;
  const MovingAxes axes((*twists_)[at(body)]);
  in_axes_.resize(x_->size());
  each(in_axes_.size(), [&](Index n, Found&) { in_axes_[at(n)] = axes.box(node(n)); });
  nodes_on_body(body, margin);
  segments_on_body(body, margin);
}

void BroadPhase::nodes_on_body(Index body, double margin) {
  const BoxTree& tree = trees_[at(body)].triangles;
  if (tree.empty()) return;
  const Box bounds = tree.bounds();
  each(scene_->net.corners.size(), [&](Index k, Found& found) {
    const Index n = scene_->net.corners[at(k)];
    const double reach = scene_->net.point_radius[at(n)] + margin;
    const Box box = widened(in_axes_[at(n)], reach);
    if (!box.intersects(bounds)) return;
    tree.visit(box, [&](Index t) {
      found.push_back({PairKind::point_triangle, kNet, n, body, t});
    });
  });
}

void BroadPhase::segments_on_body(Index body, double margin) {
  const CollisionMesh& mesh = scene_->bodies[at(body)];
  const BoxTree& tree = trees_[at(body)].edges;
  each(boxes_.size(), [&](Index s, Found& found) {
    const auto& [a, b] = scene_->net.edges[at(s)];
    const Box box = widened(in_axes_[at(a)].merged(in_axes_[at(b)]),
                            scene_->net.edge_radius[at(s)] + radius_of(mesh) + margin);
    if (is_sphere(mesh)) {
      if (box.contains(mesh.points[0])) found.push_back({PairKind::point_edge, body, 0, kNet, s});
      return;
    }
    tree.visit(box, [&](Index e) { found.push_back({PairKind::edge_edge, kNet, s, body, e}); });
  });
}

void BroadPhase::net_on_plane(Index body, double margin) {
  const BodyTwist& plane = (*twists_)[at(body)];
  const MovingAxes axes(plane);
  each(scene_->net.corners.size(), [&](Index k, Found& found) {
    const Index n = scene_->net.corners[at(k)];
    if (axes.box(node(n)).min().z() <= scene_->net.point_radius[at(n)] + margin)
      found.push_back({PairKind::point_plane, kNet, n, body, 0});
  });
}

void BroadPhase::body_on_plane(Index body, Index plane, double margin) {
  const CollisionMesh& mesh = scene_->bodies[at(body)];
  const MovingAxes axes((*twists_)[at(plane)]);
  each(mesh.corners.size(), [&](Index k, Found& found) {
    const Index p = mesh.corners[at(k)];
    if (axes.box(point(body, p)).min().z() <= mesh.point_radius[at(p)] + margin)
      found.push_back({PairKind::point_plane, body, p, plane, 0});
  });
}

void BroadPhase::body_on_body(Index first, Index second, double margin) {
  const CollisionMesh &a = scene_->bodies[at(first)], &b = scene_->bodies[at(second)];
  if (a.half_space && b.half_space) return;
  if (b.half_space) return body_on_plane(first, second, margin);
  if (a.half_space) return body_on_plane(second, first, margin);
  if (!widened(body_box(first), margin).intersects(body_box(second))) return;
  if (is_sphere(a) && is_sphere(b)) {
    each(1, [&](Index, Found& found) {
      found.push_back({PairKind::point_point, first, 0, second, 0});
    });
    return;
  }
  points_on_surface(first, second, margin);
  points_on_surface(second, first, margin);
  edges_on_edges(first, second, margin);
}

// Points against triangles; where the other side is a capsule, a sphere's point against its edge.
void BroadPhase::points_on_surface(Index from, Index to, double margin) {
  const CollisionMesh &points = scene_->bodies[at(from)], &other = scene_->bodies[at(to)];
  const bool on_capsule = is_sphere(points) && other.triangles.empty();
  const BoxTree& tree = on_capsule ? trees_[at(to)].edges : trees_[at(to)].triangles;
  if (tree.empty()) return;
  const PairKind kind = on_capsule ? PairKind::point_edge : PairKind::point_triangle;
  const MovingAxes axes((*twists_)[at(to)]);
  each(points.corners.size(), [&](Index k, Found& found) {
    const Index p = points.corners[at(k)];
    const double reach = points.point_radius[at(p)] + radius_of(other) + margin;
    tree.visit(widened(axes.box(point(from, p)), reach), [&](Index t) {
      found.push_back({kind, from, p, to, t});
    });
  });
}

void BroadPhase::edges_on_edges(Index from, Index to, double margin) {
  const CollisionMesh &edges = scene_->bodies[at(from)], &other = scene_->bodies[at(to)];
  const BoxTree& tree = trees_[at(to)].edges;
  if (tree.empty()) return;
  const MovingAxes axes((*twists_)[at(to)]);
  each(edges.edges.size(), [&](Index e, Found& found) {
    const auto& [a, b] = edges.edges[at(e)];
    const double reach = edges.edge_radius[at(e)] + radius_of(other) + margin;
    const Box box = axes.box(point(from, a)).merged(axes.box(point(from, b)));
    tree.visit(widened(box, reach), [&](Index f) {
      found.push_back({PairKind::edge_edge, from, e, to, f});
    });
  });
}

// One order whatever the trees and ranges were.
void BroadPhase::collect(const Found& of_threads) {
  with_bodies_.clear();
  parts_.append_to(with_bodies_);
  std::sort(with_bodies_.begin(), with_bodies_.end());
  pairs_.swap(found_before_);
  pairs_.clear();
  std::merge(of_threads.begin(), of_threads.end(), with_bodies_.begin(), with_bodies_.end(),
             std::back_inserter(pairs_));
  look_up_before();
}

void BroadPhase::look_up_before() {
  before_.assign(pairs_.size(), kNone);
  std::size_t old = 0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    while (old < found_before_.size() && found_before_[old] < pairs_[k]) ++old;
    if (old < found_before_.size() && found_before_[old] == pairs_[k])
      before_[k] = static_cast<Index>(old);
  }
}

}  // namespace retiarius

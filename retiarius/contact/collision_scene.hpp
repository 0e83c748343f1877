// All that can touch in a simulation, and where a pair's points are.
#pragma once

#include <array>
#include <vector>

#include "retiarius/contact/collision_mesh.hpp"
#include "retiarius/contact/contact_pair.hpp"
#include "retiarius/contact/point_motion.hpp"

namespace retiarius {

// A point of the net (owner kNet: a node) or of a body.
struct PointPlace {
  Index owner = kNet;
  Index point = kNone;
};

struct CollisionScene {
  CollisionMesh net;
  std::vector<CollisionMesh> bodies;

  const CollisionMesh& mesh(Index owner) const {
    return owner == kNet ? net : bodies[static_cast<std::size_t>(owner)];
  }

  // The points of a pair, point_count(kind) of them; of point_plane the point alone.
  std::array<PointPlace, 4> places(const ContactPair& pair) const;

  // The sum of the two primitives' radii, m: they touch where their distance is this.
  double thickness(const ContactPair& pair) const;

  // Rest lengths of the edges of an edge_edge pair, m.
  std::array<double, 2> edge_lengths(const ContactPair& pair) const;

  // Positions in world axes, nodes at x.
  PairPositions positions(const ContactPair& pair, const std::vector<Vec3>& x,
                          const std::vector<BodyState>& poses) const;

  // Motion of nodes from x by dx and of bodies.
  PairMotion motion(const ContactPair& pair, const std::vector<Vec3>& x,
                    const std::vector<Vec3>& dx, const std::vector<BodyTwist>& twists) const;
};

// The net and all bodies, with the usual chord error.
CollisionScene make_collision_scene(const Network& network, const std::vector<Body>& bodies);

}  // namespace retiarius

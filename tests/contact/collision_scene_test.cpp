#include "retiarius/contact/collision_scene.hpp"

#include <gtest/gtest.h>

namespace retiarius {
namespace {

CollisionScene thread_and_bodies() {
  Network net;
  Material thin, thick;
  thin.radius = 0.001;
  thick.radius = 0.003;
  net.materials = {thin, thick};
  net.design = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  net.segments = {{0, 1, 1.0, 0, 0}, {1, 2, 1.1, 1, 0}};
  std::vector<Body> bodies;
  for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::box, ShapeKind::plane}) {
    BodySpec spec;
    spec.shape = kind;
    spec.radius = 0.5;
    spec.size = Vec3(2, 2, 2);
    spec.motion = BodyMotion::fixed;
    bodies.push_back(build_body(spec, "."));
  }
  return make_collision_scene(net, bodies);
}

TEST(CollisionScene, ThicknessIsTheSumOfRadii) {
  const CollisionScene scene = thread_and_bodies();
  EXPECT_DOUBLE_EQ(scene.thickness({PairKind::edge_edge, kNet, 0, kNet, 1}), 0.004);
  EXPECT_DOUBLE_EQ(scene.thickness({PairKind::point_edge, 0, 0, kNet, 1}), 0.503);
  EXPECT_DOUBLE_EQ(scene.thickness({PairKind::point_triangle, kNet, 0, 1, 3}), 0.001);
  EXPECT_DOUBLE_EQ(scene.thickness({PairKind::point_triangle, kNet, 1, 1, 3}), 0.003);
  EXPECT_DOUBLE_EQ(scene.thickness({PairKind::point_plane, kNet, 1, 2, 0}), 0.003);
  EXPECT_DOUBLE_EQ(scene.thickness({PairKind::point_point, 0, 0, 1, 3}), 0.5);
}

TEST(CollisionScene, EdgeLengthsAreThoseAtRest) {
  const CollisionScene scene = thread_and_bodies();
  const auto [thread, box] = scene.edge_lengths({PairKind::edge_edge, kNet, 1, 1, 0});
  EXPECT_DOUBLE_EQ(thread, 1.1);
  EXPECT_DOUBLE_EQ(box, 2.0);
}

TEST(CollisionScene, MotionStartsAtThePositionsAndEndsAtThoseOfTheEnd) {
  const CollisionScene scene = thread_and_bodies();
  const std::vector<Vec3> x{Vec3(0, 0, 3), Vec3(1, 0, 3), Vec3(2, 0.5, 3)};
  const std::vector<Vec3> dx{Vec3(0, 0, -1), Vec3(0.1, 0, -1), Vec3(0, 0, -2)};
  std::vector<Vec3> end;
  for (std::size_t k = 0; k < x.size(); ++k) end.push_back(x[k] + dx[k]);
  std::vector<BodyState> before(3), after(3);
  after[1] = displaced(before[1], Vec3(0.1, 0.2, 0.3), Vec3(0.3, -0.2, 0.1));
  std::vector<BodyTwist> twists;
  for (std::size_t k = 0; k < 3; ++k) twists.push_back(motion_between(before[k], after[k]));
  for (const ContactPair& pair : {ContactPair{PairKind::edge_edge, kNet, 0, kNet, 1},
                                  {PairKind::point_edge, 0, 0, kNet, 1},
                                  {PairKind::edge_edge, kNet, 1, 1, 4},
                                  {PairKind::point_triangle, kNet, 2, 1, 7},
                                  {PairKind::point_plane, kNet, 2, 2, 0}}) {
    const PairMotion motion = scene.motion(pair, x, dx, twists);
    const PairPositions at_start = scene.positions(pair, x, before);
    const PairPositions at_end = scene.positions(pair, end, after);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT((motion.at(0.0)[i] - at_start[i]).norm(), 1e-14);
      EXPECT_LT((motion.at(1.0)[i] - at_end[i]).norm(), 1e-14);
    }
  }
  const auto places = scene.places({PairKind::point_triangle, kNet, 2, 1, 7});
  EXPECT_EQ(places[0].owner, kNet);
  EXPECT_EQ(places[0].point, 2);
  EXPECT_EQ(places[3].owner, 1);
  EXPECT_EQ(places[3].point, scene.bodies[1].triangles[7][2]);
}

}  // namespace
}  // namespace retiarius

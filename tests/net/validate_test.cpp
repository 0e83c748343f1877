#include <functional>

#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;

std::string refusal(const std::function<void(Network&)>& damage) {
  Network net = build_network(net_of(Pattern::square, 1.0, 0.5, 2));
  EXPECT_NO_THROW(validate(net));
  damage(net);
  return error_of<Error>([&] { validate(net); });
}

TEST(Validate, Nodes) {
  EXPECT_EQ(refusal([](Network& n) { n.initial[3].y() = kInfinity; }),
            "network: node 3 has a position or velocity that is not finite");
  EXPECT_EQ(refusal([](Network& n) { n.mass[2] = 0.0; }),
            "network: node 2 has mass 0 kg, must be greater than 0");
  EXPECT_EQ(refusal([](Network& n) { n.mass.pop_back(); }),
            "network: 21 nodes, but 21 initial positions, 21 velocities and 20 masses");
}

TEST(Validate, Materials) {
  EXPECT_EQ(refusal([](Network& n) { n.materials.clear(); }), "network: has no material");
  EXPECT_EQ(refusal([](Network& n) {
              n.materials[0] = {};
              n.materials[0].radius = 1.0;
            }),
            "network: material 0 needs radius 1 m, EA 0 N and line density 0 kg/m greater than 0");
  EXPECT_EQ(refusal([](Network& n) { n.materials[0].bending_stiffness = -1.0; }),
            "network: material 0 has EI -1 N m2, damping 0 s or strength inf N out of range");
}

TEST(Validate, Segments) {
  EXPECT_EQ(refusal([](Network& n) { n.segments.clear(); }), "network: has no segment");
  EXPECT_EQ(refusal([](Network& n) { n.segments[1].b = 99; }),
            "network: segment 1 joins nodes 9 and 99");
  EXPECT_EQ(refusal([](Network& n) { n.segments[4].rest_length = 0.0; }),
            "network: segment 4 has rest length 0 m, must be greater than 0");
  EXPECT_EQ(refusal([](Network& n) { n.segments[4].material = 1; }),
            "network: segment 4 has material 1 of 1");
  EXPECT_EQ(refusal([](Network& n) { n.segments[4].thread = -1; }),
            "network: segment 4 has thread -1 of 6");
}

TEST(Validate, JointsAndThreads) {
  EXPECT_EQ(refusal([](Network& n) { n.joints[0].second = 7; }),
            "network: joint 0 (8, 9, 7) does not join its segments 0 and 7");
  EXPECT_EQ(refusal([](Network& n) { n.joints[0].voronoi_length = 0.0; }),
            "network: joint 0 has length 0 m or EI 0 N m2 out of range");
  EXPECT_EQ(refusal([](Network& n) { std::swap(n.threads[0].nodes[1], n.threads[0].nodes[2]); }),
            "network: thread 0 does not run along its segment 0");
  EXPECT_EQ(refusal([](Network& n) { n.threads[0].nodes.pop_back(); }),
            "network: thread 0 has 4 nodes and 4 segments");
}

TEST(Validate, Names) {
  EXPECT_EQ(refusal([](Network& n) { n.center = kNone; }), "network: center names node -1 of 21");
  EXPECT_EQ(refusal([](Network& n) { n.perimeter.push_back(21); }),
            "network: perimeter names node 21 of 21");
  EXPECT_EQ(refusal([](Network& n) { n.bullets.pop_back(); }),
            "network: has 4 corners but 3 bullets");
}

}  // namespace
}  // namespace retiarius

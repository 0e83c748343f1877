#include <cmath>

#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;

void expect_unstrained(const Network& net) {
  for (const Segment& s : net.segments) {
    EXPECT_NEAR((net.initial[s.b] - net.initial[s.a]).norm(), s.rest_length, 1e-9 * s.rest_length);
  }
}

TEST(Placement, ScaleMovesNodesButKeepsRestLengths) {
  NetSpec spec = net_of(Pattern::hexagon, 1.0, 0.2, 4);
  spec.scale = 0.05;
  spec.position = Vec3(1, 2, 3);
  const Network net = build_network(spec);
  for (Index i = 0; i < net.node_count(); ++i) {
    EXPECT_NEAR((net.initial[i] - (0.05 * net.design[i] + Vec3(1, 2, 3))).norm(), 0.0, 1e-15);
    EXPECT_EQ(net.velocity[i], Vec3::Zero());
  }
  EXPECT_DOUBLE_EQ(net.segments[0].rest_length, 0.05);
}

TEST(Placement, HeightsOfAFileAreNotScaled) {
  NetSpec spec = file_of(data_file("dome.net"));
  spec.scale = 0.5;
  const Network net = build_network(spec);
  EXPECT_EQ(net.initial[1], Vec3(0, 0.5, 0));
  EXPECT_EQ(net.initial[3], Vec3(0, 0, 0.5));
  spec.zigzag = true;
  EXPECT_EQ(error_of<InputError>([&] { build_network(spec); }),
            "net.zigzag = true: the net as designed must be flat");
}

TEST(Placement, ZigzagOfTheStiffCapture) {
  NetSpec spec = net_of(Pattern::square, 5.0, 0.2, 2);
  spec.scale = 0.25;
  spec.zigzag = true;
  const Network net = build_network(spec);
  const auto knots = static_cast<Index>(net.knots.size());
  for (Index i = 0; i < net.node_count(); ++i) {
    EXPECT_NEAR(net.initial[i].z(), i < knots ? 0.0 : 0.0968245837, 1e-9);
  }
  expect_unstrained(net);
}

TEST(Placement, ZigzagWithOneSegmentLiftsEverySecondKnot) {
  NetSpec spec = net_of(Pattern::square, 2.0, 0.5);
  spec.scale = 0.6;
  spec.zigzag = true;
  const Network net = build_network(spec);
  EXPECT_EQ(net.initial[net.corners[0]].z(), 0.0);
  EXPECT_NEAR(net.initial[net.perimeter[1]].z(), 0.4, 1e-14);
  EXPECT_NEAR(net.initial[net.perimeter[2]].z(), 0.0, 1e-14);
  expect_unstrained(net);
}

// Pieces of two lengths meet in the knots of a diamond mesh: mid-piece nodes take lifts of their
// own.
TEST(Placement, ZigzagWithPiecesOfTwoLengthsAndBridles) {
  NetSpec spec = diamond_of(Pattern::square, 2.0, 0.5, 2);
  spec.scale = 0.3;
  spec.zigzag = true;
  spec.corner_mass.bridle = 0.7;
  spec.corner_mass.bridle_segments = 4;
  expect_unstrained(build_network(spec));
}

TEST(Placement, ZigzagAtFullScaleIsFlat) {
  NetSpec spec = net_of(Pattern::hexagon, 1.0, 0.2, 2);
  spec.zigzag = true;
  for (const Vec3& x : build_network(spec).initial) EXPECT_NEAR(x.z(), 0.0, 1e-7);
}

TEST(Placement, ZigzagRefusesAGraphThatIsNotBipartite) {
  NetSpec spec = net_of(Pattern::hexagon, 1.0, 0.2, 1);
  spec.scale = 0.5;
  spec.zigzag = true;
  EXPECT_THAT(error_of<InputError>([&] { build_network(spec); }),
              AllOf(HasSubstr("net.zigzag = true: nodes "),
                    HasSubstr("lie equally far from corner0 (the graph is not bipartite); an even "
                              "net.segments makes it so")));
  spec.segments = 2;
  expect_unstrained(build_network(spec));
}

TEST(Placement, ZigzagRefusesLengthsThatCannotBeKept) {
  NetSpec spec = net_of(Pattern::square, 1.0, 1.0);
  spec.scale = 0.5;
  spec.zigzag = true;
  spec.corner_mass.bridle = 0.3;
  EXPECT_THAT(error_of<InputError>([&] { build_network(spec); }),
              AllOf(HasSubstr("net.zigzag = true: node "),
                    HasSubstr("cannot keep the lengths of its segments: lifts of ")));
}

TEST(Placement, ZigzagRefusesAStretchedSegment) {
  NetSpec spec = file_of(data_file("stretched.net"));
  spec.scale = 0.9;
  spec.zigzag = true;
  EXPECT_EQ(error_of<InputError>([&] { build_network(spec); }),
            "net.zigzag = true: segment 0 is stretched already in the plane (rest length 0.5 m)");
}

TEST(Placement, ZigzagRefusesLooseParts) {
  NetSpec spec = file_of(data_file("two_parts.net"));
  spec.zigzag = true;
  EXPECT_EQ(error_of<InputError>([&] { build_network(spec); }),
            "net.zigzag = true: node 2 is not connected to corner0");
}

}  // namespace
}  // namespace retiarius

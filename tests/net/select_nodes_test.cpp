#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Network bridled() {
  NetSpec spec = net_of(Pattern::hexagon, 1.0, 0.5, 2);
  spec.corner_mass.bridle = 0.5;
  return build_network(spec);
}

TEST(SelectNodes, Groups) {
  const Network net = bridled();
  EXPECT_THAT(select_nodes(net, "none"), IsEmpty());
  EXPECT_THAT(select_nodes(net, "all"), SizeIs(net.design.size()));
  EXPECT_EQ(select_nodes(net, "all").back(), net.node_count() - 1);
  EXPECT_EQ(select_nodes(net, "corners"), net.corners);
  EXPECT_EQ(select_nodes(net, "bullets"), net.bullets);
  EXPECT_EQ(select_nodes(net, "perimeter"), net.perimeter);
  EXPECT_EQ(select_nodes(net, "knots"), net.knots);
}

TEST(SelectNodes, SingleNodes) {
  const Network net = bridled();
  EXPECT_THAT(select_nodes(net, "center"), ElementsAre(net.center));
  EXPECT_THAT(select_nodes(net, "corner3"), ElementsAre(net.corners[3]));
  EXPECT_THAT(select_nodes(net, "bullet0"), ElementsAre(net.bullets[0]));
  EXPECT_NE(net.corners[0], net.bullets[0]);
  EXPECT_THAT(select_nodes(net, "17"), ElementsAre(17));
}

TEST(SelectNodes, UnknownNamesListTheAllowedOnes) {
  const Network net = build_network(net_of(Pattern::hexagon, 1.0, 0.5));
  EXPECT_EQ(error_of<InputError>([&] { select_nodes(net, "centre"); }),
            "\"centre\" names no nodes; allowed: none, all, corners, bullets, perimeter, knots, "
            "center, corner0 to corner5, bullet0 to bullet5, or an index from 0 to 18");
  for (const char* name :
       {"corner6", "corner", "corner-1", "bullet6", "19", "-1", "1.0", "", "3x"}) {
    EXPECT_THROW(select_nodes(net, name), InputError) << name;
  }
}

TEST(MedianRestLength, OddEvenAndNone) {
  Network net;
  EXPECT_THROW(median_rest_length(net), Error);
  for (const double length : {5.0, 1.0, 2.0}) net.segments.push_back({0, 1, length, 0, 0});
  EXPECT_EQ(median_rest_length(net), 2.0);
  net.segments.push_back({0, 1, 3.0, 0, 0});
  EXPECT_EQ(median_rest_length(net), 2.5);
}

}  // namespace
}  // namespace retiarius

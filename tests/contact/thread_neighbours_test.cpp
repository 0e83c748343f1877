#include "retiarius/contact/thread_neighbours.hpp"

#include <gtest/gtest.h>

namespace retiarius {
namespace {

// A straight thread of `count` equal segments over `length`.
Network straight_thread(int count, double length, double radius) {
  Network net;
  Material material;
  material.radius = radius;
  net.materials = {material};
  for (Index k = 0; k <= count; ++k) net.design.emplace_back(length * k / count, 0.0, 0.0);
  for (Index k = 0; k < count; ++k) net.segments.push_back({k, k + 1, length / count, 0, 0});
  return net;
}

TEST(ThreadNeighbours, ShareANode) {
  const ThreadNeighbours long_segments(straight_thread(4, 4.0, 0.01));
  EXPECT_TRUE(long_segments.are_neighbours(0, 1));
  EXPECT_TRUE(long_segments.are_neighbours(1, 0));
  EXPECT_FALSE(long_segments.are_neighbours(0, 2));
  EXPECT_FALSE(long_segments.are_neighbours(0, 3));
}

// Segments of 5 mm of a thread of radius 10 mm: with a multiple of 3 what lies within 60 mm along
// the thread is a neighbour, however the thread is cut.
TEST(ThreadNeighbours, AreToldByLengthAlongTheThread) {
  for (const int count : {100, 200, 400}) {
    const double segment = 1.0 / count;
    const ThreadNeighbours neighbours(straight_thread(count, 1.0, 0.01), 3.0);
    for (Index other = 1; other < count; ++other) {
      const double way = (other - 1) * segment;
      if (std::abs(way - 0.06) < 1e-9) continue;
      EXPECT_EQ(neighbours.are_neighbours(0, other), way < 0.06) << count << " " << other;
      EXPECT_EQ(neighbours.are_neighbours(other, 0), way < 0.06) << count << " " << other;
    }
  }
}

// A second thread crosses in the middle: the way leads through the knot.
TEST(ThreadNeighbours, FollowTheNetThroughKnots) {
  Network net = straight_thread(4, 0.04, 0.001);
  net.design.emplace_back(0.02, 0.01, 0.0);
  net.design.emplace_back(0.02, 0.02, 0.0);
  net.segments.push_back({2, 5, 0.01, 0, 1});
  net.segments.push_back({5, 6, 0.01, 0, 1});
  const ThreadNeighbours narrow(net, 3.0), wide(net, 5.5);
  EXPECT_TRUE(narrow.are_neighbours(1, 4));
  EXPECT_FALSE(narrow.are_neighbours(0, 4));  // 10 mm apart along the net; 6 mm count
  EXPECT_TRUE(wide.are_neighbours(0, 4));     // 11 mm count
  EXPECT_FALSE(wide.are_neighbours(0, 5));
}

TEST(ThreadNeighbours, CountBothRadii) {
  Network net = straight_thread(3, 0.03, 0.001);
  Material thick;
  thick.radius = 0.003;
  net.materials.push_back(thick);
  net.segments[2].material = 1;
  EXPECT_TRUE(ThreadNeighbours(net, 3.0).are_neighbours(0, 2));  // 12 mm count
  net.segments[2].material = 0;
  EXPECT_FALSE(ThreadNeighbours(net, 3.0).are_neighbours(0, 2));  // 6 mm count
}

}  // namespace
}  // namespace retiarius

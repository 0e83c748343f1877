#include <cmath>
#include <numeric>

#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Build, HexagonMass) {
  EXPECT_NEAR(total(build_network(net_of(Pattern::hexagon, 1.0, 0.2, 4)).mass), 11.309734, 1e-6);
}

TEST(Build, NodeMassIsHalfOfEachSegmentPlusKnotAndCorner) {
  NetSpec spec = net_of(Pattern::square, 2.0, 1.0, 2);
  spec.knot_mass = 0.25;
  spec.corner_mass.mass = 3.0;
  const Network net = build_network(spec);
  const double half = 1000.0 * kPi * 1e-4 * 0.25;  // half of a segment of 0.5 m
  EXPECT_NEAR(net.mass[net.center], 4 * half + 0.25, 1e-14);
  EXPECT_NEAR(net.mass[net.corners[2]], 2 * half + 0.25 + 3.0, 1e-14);
  EXPECT_NEAR(net.mass.back(), 2 * half, 1e-14) << "an inner node of a piece is no knot";
  EXPECT_NEAR(total(net.mass), 12 * 4 * half + 9 * 0.25 + 4 * 3.0, 1e-12);
}

TEST(Build, Stiffness) {
  NetSpec spec = net_of(Pattern::square, 1.0, 0.5);
  spec.thread.strength = 500.0;
  spec.thread.material_damping = 1e-4;
  spec.thread.compression = false;
  const Material material = build_network(spec).materials.at(0);
  EXPECT_DOUBLE_EQ(material.axial_stiffness, 1e6 * kPi * 1e-4);
  EXPECT_DOUBLE_EQ(material.line_density, 1e3 * kPi * 1e-4);
  EXPECT_EQ(material.bending_stiffness, 0.0) << "bending is none";
  EXPECT_EQ(material.strength, 500.0);
  EXPECT_EQ(material.damping, 1e-4);
  EXPECT_FALSE(material.compression);
  spec.thread.bending = Bending::bounded;
  EXPECT_DOUBLE_EQ(build_network(spec).materials.at(0).bending_stiffness, 1e6 * kPi * 1e-8 / 4.0);
  spec.thread.bending_stiffness = 2e-6;
  EXPECT_EQ(build_network(spec).materials.at(0).bending_stiffness, 2e-6);
  EXPECT_EQ(build_network(spec).joints.at(0).bending_stiffness, 2e-6);
}

TEST(Build, BorderHasItsOwnMaterialOnlyWhereItDiffers) {
  NetSpec spec = net_of(Pattern::square, 2.0, 1.0);
  spec.border.radius = spec.thread.radius;
  EXPECT_EQ(build_network(spec).materials.size(), 1u);
  spec.border.radius = 0.02;
  const Network net = build_network(spec);
  ASSERT_EQ(net.materials.size(), 2u);
  EXPECT_DOUBLE_EQ(net.materials[1].axial_stiffness, 4.0 * net.materials[0].axial_stiffness);
  for (const Segment& s : net.segments) {
    EXPECT_EQ(s.material, net.threads[s.thread].perimeter ? 1 : 0);
  }
  // 8 m of border of four times the thread's line density, 4 m of thread.
  EXPECT_NEAR(total(net.mass), (8.0 * 4.0 + 4.0) * net.materials[0].line_density, 1e-12);
}

TEST(Build, CenterIsTheKnotNearestTheCentroid) {
  EXPECT_EQ(build_network(net_of(Pattern::hexagon, 1.0, 0.2, 4)).center, 0);
  const Network even = build_network(net_of(Pattern::square, 2.0, 0.5, 3));
  EXPECT_EQ(even.design[even.center], Vec3::Zero());
  // Three pieces a side: four knots are equally near, the lowest index is at (-, -).
  const Network odd = build_network(net_of(Pattern::square, 3.0, 1.0, 2));
  EXPECT_EQ(odd.center, 5);
  EXPECT_EQ(odd.design[odd.center], Vec3(-0.5, -0.5, 0.0));
}

TEST(Build, RoundingDoesNotDecideBetweenCenters) {
  for (int n = 1; n <= 40; ++n) {
    for (const NetSpec& spec :
         {net_of(Pattern::triangle, 1.0, 1.0 / n), net_of(Pattern::square, 1.0, 1.0 / n)}) {
      const Network net = build_network(spec);
      const double distance = net.design[net.center].norm();
      for (Index i = 0; i < net.center; ++i) EXPECT_GT(net.design[i].norm(), distance + 1e-6);
      for (const Vec3& x : net.design) EXPECT_GT(x.norm(), distance - 1e-12);
    }
  }
}

TEST(Build, KnotsComeFirstThenInnerNodesPieceByPiece) {
  const Network net = build_network(net_of(Pattern::hexagon, 1.0, 0.5, 3));
  for (std::size_t i = 0; i < net.knots.size(); ++i) EXPECT_EQ(net.knots[i], Index(i));
  const Thread& thread = net.threads.front();
  const auto first = static_cast<Index>(net.knots.size());
  EXPECT_EQ(thread.nodes[1], first);
  EXPECT_EQ(thread.nodes[2], first + 1);
  EXPECT_EQ(thread.nodes[4], first + 2);
}

TEST(Build, HingedKnotsKeepOnlyJointsInsidePieces) {
  NetSpec spec = net_of(Pattern::hexagon, 1.0, 0.2, 4);
  spec.knots = Knots::hinged;
  const Network net = build_network(spec);
  EXPECT_EQ(net.joints.size(), 3u * 180u);
  for (const Joint& j : net.joints) EXPECT_GE(j.b, Index(net.knots.size()));
}

TEST(Build, JointLengths) {
  const Network net = build_network(polygon_of(5, 1.0, 0.25, 2));
  for (const Joint& j : net.joints) {
    EXPECT_DOUBLE_EQ(j.voronoi_length,
                     (net.segments[j.first].rest_length + net.segments[j.second].rest_length) / 2);
  }
}

TEST(Build, BridlesLeadOutwardToTheBullets) {
  NetSpec spec = net_of(Pattern::square, 2.0, 1.0, 2);
  spec.corner_mass.mass = 3.0;
  spec.corner_mass.bridle = 0.6;
  spec.corner_mass.bridle_segments = 3;
  spec.border.radius = 0.02;
  const Network net = build_network(spec);
  const Network plain = build_network(net_of(Pattern::square, 2.0, 1.0, 2));
  EXPECT_NO_THROW(validate(net));
  EXPECT_EQ(net.node_count(), plain.node_count() + 4 * 3);
  EXPECT_EQ(net.joints.size(), plain.joints.size() + 4 * 2);
  EXPECT_EQ(net.corners, plain.corners);
  EXPECT_EQ(net.perimeter, plain.perimeter);
  EXPECT_EQ(net.knots, plain.knots);
  const double r = 0.6 / std::sqrt(2.0);
  EXPECT_NEAR((net.design[net.bullets[0]] - Vec3(1 + r, 1 + r, 0)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((net.design[net.bullets[2]] - Vec3(-1 - r, -1 - r, 0)).norm(), 0.0, 1e-14);
  const double border_half = 1000.0 * kPi * 4e-4 * 0.1;  // half of a bridle segment of 0.2 m
  EXPECT_NEAR(net.mass[net.bullets[0]], 3.0 + border_half, 1e-12);
  EXPECT_NEAR(net.mass[net.corners[0]], plain.mass[plain.corners[0]] * 4.0 + border_half, 1e-12);
  EXPECT_EQ(net.segments.back().material, 1);
  EXPECT_DOUBLE_EQ(net.segments.back().rest_length, 0.2);
}

TEST(Build, WithoutBridleTheCornersAreTheBullets) {
  const Network net = build_network(net_of(Pattern::triangle, 2.0, 1.0, 2));
  EXPECT_EQ(net.bullets, net.corners);
}

TEST(Build, NetOfOneCell) {
  const Network net = build_network(net_of(Pattern::square, 1.0, 1.0));
  EXPECT_EQ(net.node_count(), 4);
  EXPECT_EQ(net.segment_count(), 4);
  EXPECT_TRUE(net.joints.empty());
  EXPECT_NO_THROW(validate(net));
}

}  // namespace
}  // namespace retiarius

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;
using Key = std::array<long, 2>;

Key key_of(const Vec3& x) { return {std::lround(x.x() * 1e7), std::lround(x.y() * 1e7)}; }

using SegmentSet = std::set<std::pair<Key, Key>>;

// The net's segments by the places of their ends, after a motion of the plane.
template <typename Motion>
SegmentSet moved_segments(const Network& net, Motion&& motion) {
  SegmentSet set;
  for (const Segment& s : net.segments) {
    const Key a = key_of(motion(net.design[s.a])), b = key_of(motion(net.design[s.b]));
    set.insert({std::min(a, b), std::max(a, b)});
  }
  return set;
}

SegmentSet turned(const Network& net, double angle) {
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  // A shift by an irrational fraction of the grid keeps places off the edges of its cells.
  const Vec3 shift(0.31415926e-8, 0.27182818e-8, 0.0);
  return moved_segments(net, [&](const Vec3& x) -> Vec3 { return turn * x + shift; });
}

TEST(Patterns, AreSymmetricUnderTheirTurn) {
  for (const auto& [name, spec] : all_patterns(1.0, 0.25, 2)) {
    if (name == "triangle diamond" || name == "polygon 101") continue;
    SCOPED_TRACE(name);
    const Network net = build_network(spec);
    const double angle = 2.0 * kPi / double(net.corners.size());
    EXPECT_EQ(turned(net, angle), turned(net, 0.0));
    EXPECT_NE(turned(net, 0.5 * angle), turned(net, 0.0));
    EXPECT_EQ(turned(net, 0.0).size(), net.segments.size());
  }
}

TEST(Patterns, DiamondTriangleIsItsMirrorImage) {
  const Network net = build_network(diamond_of(Pattern::triangle, 1.0, 0.25, 2));
  const auto mirrored =
      moved_segments(net, [](const Vec3& x) { return Vec3(x.x() + 3e-9, -x.y() + 3e-9, 0.0); });
  const auto plain =
      moved_segments(net, [](const Vec3& x) { return Vec3(x.x() + 3e-9, x.y() + 3e-9, 0.0); });
  EXPECT_EQ(mirrored, plain);
  EXPECT_NE(turned(net, 2.0 * kPi / 3.0), turned(net, 0.0));
}

TEST(Patterns, SixSidedPolygonIsTheHexagon) {
  const Network a = build_network(net_of(Pattern::hexagon, 2.0, 0.5, 3));
  const Network b = build_network(polygon_of(6, 2.0, 0.5, 3));
  EXPECT_EQ(a.design, b.design);
  ASSERT_EQ(a.joints.size(), b.joints.size());
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    EXPECT_EQ(a.segments[i].a, b.segments[i].a);
    EXPECT_EQ(a.segments[i].b, b.segments[i].b);
  }
}

TEST(Patterns, RestLengthsAreDesignLengths) {
  for (const auto& [name, spec] : all_patterns(3.0, 0.5, 2)) {
    SCOPED_TRACE(name);
    const Network net = build_network(spec);
    for (const Segment& s : net.segments) {
      EXPECT_NEAR((net.design[s.b] - net.design[s.a]).norm(), s.rest_length, 1e-13);
    }
  }
}

TEST(Patterns, PieceLengthsAreAsDocumented) {
  const double mesh = 0.25;
  for (const auto& [name, spec] : all_patterns(1.0, mesh, 1)) {
    SCOPED_TRACE(name);
    const Network net = build_network(spec);
    const bool sectors = name.starts_with("polygon") || name == "square diamond";
    const double inner = sectors ? mesh / (2.0 * std::sin(kPi / double(net.corners.size()))) : mesh;
    for (const Segment& s : net.segments) {
      EXPECT_NEAR(s.rest_length, net.threads[s.thread].perimeter ? mesh : inner, 1e-14);
    }
  }
}

TEST(Patterns, HexagonDegrees) {
  const Network net = build_network(net_of(Pattern::hexagon, 1.0, 0.2));
  std::vector<int> degree(net.design.size(), 0);
  for (const Segment& s : net.segments) ++degree[s.a], ++degree[s.b];
  for (const Index knot : net.knots) {
    const bool corner = std::count(net.corners.begin(), net.corners.end(), knot) > 0;
    EXPECT_EQ(degree[knot], knot == net.center ? 6 : corner ? 3 : 4);
  }
}

// Rhombic cells: inner threads are parallel to a spoke, but only the perimeter to an outer side
// across its own sector.
TEST(Patterns, HexagonSectorLinesAreParallelToTheirSpokes) {
  const Network net = build_network(net_of(Pattern::hexagon, 1.0, 0.2));
  for (const Segment& s : net.segments) {
    if (net.threads[s.thread].perimeter) continue;
    const Vec3 middle = (net.design[s.a] + net.design[s.b]) / 2.0;
    const Vec3 along = (net.design[s.b] - net.design[s.a]).normalized();
    double angle = std::atan2(middle.y(), middle.x());
    if (angle < 0.0) angle += 2.0 * kPi;
    // A segment on a spoke may count to either of its sectors: it is parallel to its own spoke.
    const double sector = std::floor(angle / (kPi / 3.0) + 1e-9);
    double best = 0.0;
    for (const double spoke : {sector, sector + 1.0}) {
      const Vec3 u(std::cos(spoke * kPi / 3.0), std::sin(spoke * kPi / 3.0), 0.0);
      best = std::max(best, std::abs(along.dot(u)));
    }
    EXPECT_NEAR(best, 1.0, 1e-12);
  }
}

TEST(Patterns, JointsAreStraightAndThreadsRunAlongTheirSegments) {
  for (const auto& [name, spec] : all_patterns(1.0, 0.25, 2)) {
    SCOPED_TRACE(name);
    const Network net = build_network(spec);
    EXPECT_NO_THROW(validate(net));
    for (const Joint& j : net.joints) {
      const Vec3 t1 = (net.design[j.b] - net.design[j.a]).normalized();
      const Vec3 t2 = (net.design[j.c] - net.design[j.b]).normalized();
      EXPECT_NEAR(t1.dot(t2), 1.0, 1e-12);
      EXPECT_EQ(net.segments[j.first].thread, net.segments[j.second].thread);
    }
    std::size_t covered = 0;
    for (const Thread& thread : net.threads) {
      covered += thread.segments.size();
      const Vec3 line = net.design[thread.nodes.back()] - net.design[thread.nodes.front()];
      double length = 0.0;
      for (const Index s : thread.segments) length += net.segments[s].rest_length;
      EXPECT_NEAR(line.norm(), length, 1e-12) << "a thread is not straight";
    }
    EXPECT_EQ(covered, net.segments.size());
  }
}

// Without a joint, no two segments of a natural net that meet in a node are collinear.
TEST(Patterns, NoStraightContinuationIsMissed) {
  for (const auto& [name, spec] : all_patterns(1.0, 0.25, 2)) {
    if (name == "polygon 101") continue;  // neighbouring spokes are nearly opposite there
    SCOPED_TRACE(name);
    const Network net = build_network(spec);
    std::vector<std::vector<Vec3>> directions(net.design.size());
    for (const Segment& s : net.segments) {
      const Vec3 t = (net.design[s.b] - net.design[s.a]).normalized();
      directions[s.a].push_back(t);
      directions[s.b].push_back(-t);
    }
    std::size_t straight = 0;
    for (const auto& around : directions) {
      for (std::size_t i = 0; i < around.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) straight += around[i].dot(around[k]) < -0.999;
      }
    }
    EXPECT_EQ(straight, net.joints.size());
  }
}

TEST(Patterns, OutlineIsCounterClockwiseFromCornerZero) {
  for (const auto& [name, spec] : all_patterns(1.0, 0.25, 2)) {
    SCOPED_TRACE(name);
    const Network net = build_network(spec);
    EXPECT_EQ(net.perimeter.front(), net.corners.front());
    EXPECT_EQ(net.perimeter.size(), 8 * net.corners.size());
    double area = 0.0, length = 0.0;
    for (std::size_t i = 0; i < net.perimeter.size(); ++i) {
      const Vec3 &p = net.design[net.perimeter[i]],
                 &q = net.design[net.perimeter[(i + 1) % net.perimeter.size()]];
      area += 0.5 * p.cross(q).z();
      length += (q - p).norm();
    }
    const double corners = double(net.corners.size());
    EXPECT_NEAR(length, corners, 1e-12);
    EXPECT_NEAR(area, corners / (4.0 * std::tan(kPi / corners)), 1e-10);
    for (std::size_t k = 0; k < net.corners.size(); ++k) {
      EXPECT_EQ(net.perimeter[8 * k], net.corners[k]);
    }
  }
}

TEST(Patterns, CornersStartWhereTheyShould) {
  const auto corner = [](const NetSpec& spec, std::size_t k) {
    const Network net = build_network(spec);
    return net.design[net.corners[k]];
  };
  const auto near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-14; };
  EXPECT_EQ(corner(net_of(Pattern::hexagon, 2.0, 0.5), 0), Vec3(2, 0, 0));
  EXPECT_TRUE(near(corner(net_of(Pattern::hexagon, 2.0, 0.5), 1), Vec3(1, std::sqrt(3.0), 0)));
  EXPECT_EQ(corner(net_of(Pattern::square, 2.0, 0.5), 0), Vec3(1, 1, 0));
  EXPECT_EQ(corner(net_of(Pattern::square, 2.0, 0.5), 1), Vec3(-1, 1, 0));
  EXPECT_EQ(corner(net_of(Pattern::square, 2.0, 0.5), 2), Vec3(-1, -1, 0));
  EXPECT_TRUE(near(corner(diamond_of(Pattern::square, 2.0, 0.5), 0), Vec3(1, 1, 0)));
  EXPECT_TRUE(near(corner(net_of(Pattern::triangle, 3.0, 0.5), 0), Vec3(std::sqrt(3.0), 0, 0)));
  EXPECT_TRUE(
      near(corner(net_of(Pattern::triangle, 3.0, 0.5), 1), Vec3(-std::sqrt(3.0) / 2.0, 1.5, 0)));
}

}  // namespace
}  // namespace retiarius

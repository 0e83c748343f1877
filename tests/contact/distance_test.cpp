#include "retiarius/contact/distance.hpp"

#include <cmath>

#include "tests/contact/distance_oracle.hpp"

namespace retiarius {
namespace {

using testing::check_random_distances;
using testing::Stream;

TEST(Distance, OfRandomAndDegeneratePairs) { check_random_distances(1, 30000); }

// Sampling knows nothing of features: no two samples are nearer than the distance, and the nearest
// of a fine lattice are hardly farther.
TEST(Distance, IsThatOfTheNearestSamples) {
  Stream random(2);
  constexpr int kSteps = 60;
  for (int k = 0; k < 60; ++k) {
    PairPositions p;
    for (Vec3& x : p) x = random.vector();
    double triangle = kInfinity, edges = kInfinity;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps; ++j) {
        const double s = i / double(kSteps), t = j / double(kSteps);
        const Vec3 on_edge = p[0] + s * (p[1] - p[0]), on_other = p[2] + t * (p[3] - p[2]);
        edges = std::min(edges, (on_edge - on_other).norm());
        const Vec3 inside = p[1] + s * (p[2] - p[1] + t * (p[3] - p[2]));
        triangle = std::min(triangle, (p[0] - inside).norm());
      }
    }
    const double reach = 3.5 / kSteps;  // the longest edge over the steps
    const double on_triangle = distance(PairKind::point_triangle, p).value;
    EXPECT_LE(on_triangle, triangle + 1e-14);
    EXPECT_GE(on_triangle, triangle - reach);
    const double on_edges = distance(PairKind::edge_edge, p).value;
    EXPECT_LE(on_edges, edges + 1e-14);
    EXPECT_GE(on_edges, edges - reach);
  }
}

TEST(Distance, NamesTheActiveFeature) {
  const PairPositions over_face{Vec3(0.2, 0.2, 1), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(distance(PairKind::point_triangle, over_face).active, 0b1111);
  const PairPositions over_edge{Vec3(0.5, -1, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(distance(PairKind::point_triangle, over_edge).active, 0b0111);
  const PairPositions at_corner{Vec3(-1, -1, 2), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(distance(PairKind::point_triangle, at_corner).active, 0b0011);
  const PairPositions crossed{Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(0, -1, 0), Vec3(0, 1, 0)};
  const Distance inner = distance(PairKind::edge_edge, crossed);
  EXPECT_EQ(inner.active, 0b1111);
  EXPECT_DOUBLE_EQ(inner.value, 1.0);
  EXPECT_EQ(inner.normal, Vec3(0, 0, 1));
  const PairPositions end_on{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  const Distance ends = distance(PairKind::edge_edge, end_on);
  EXPECT_EQ(ends.active, 0b0110);
  EXPECT_EQ(ends.normal, Vec3(-1, 0, 0));
}

TEST(Distance, OfCrossingEdgesIsZeroWithTheirCommonNormal) {
  const PairPositions p{Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.5, 1, 0)};
  const Distance at = distance(PairKind::edge_edge, p);
  EXPECT_EQ(at.value, 0.0);
  EXPECT_NEAR(std::abs(at.normal.z()), 1.0, 1e-15);
  const PairPositions pierced{Vec3(0.2, 0.3, 0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Distance in_face = distance(PairKind::point_triangle, pierced);
  EXPECT_EQ(in_face.value, 0.0);
  EXPECT_NEAR(std::abs(in_face.normal.z()), 1.0, 1e-15);
}

TEST(Distance, GuardsZeroLengths) {
  const Vec3 a(0.3, -0.2, 0.1), b(0.3, 0.8, 0.1), c(1.3, 0.8, 0.1);
  EXPECT_DOUBLE_EQ(distance(PairKind::edge_edge, {a, a, b, b}).value, 1.0);
  EXPECT_DOUBLE_EQ(distance(PairKind::edge_edge, {a, a, b, c}).value, 1.0);
  EXPECT_DOUBLE_EQ(distance(PairKind::edge_edge, {b, c, a, a}).value, 1.0);
  EXPECT_DOUBLE_EQ(distance(PairKind::point_edge, {a, b, b, {}}).value, 1.0);
  EXPECT_DOUBLE_EQ(distance(PairKind::point_triangle, {a, b, b, b}).value, 1.0);
  EXPECT_DOUBLE_EQ(distance(PairKind::point_triangle, {a, b, c, c}).value, 1.0);
  for (const PairKind kind : testing::kBoundedKinds) {
    const Distance same = distance(kind, {a, a, a, a});
    EXPECT_EQ(same.value, 0.0);
    EXPECT_DOUBLE_EQ(same.normal.norm(), 1.0);
  }
}

TEST(Distance, OfEdgesIsNoNumberWhereAPositionIsNone) {
  const PairPositions p{Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(0, -1, 0), Vec3(0, 1, 0)};
  for (std::size_t i = 0; i < 4; ++i) {
    PairPositions lost = p;
    lost[i].y() = std::nan("");
    EXPECT_TRUE(std::isnan(distance(PairKind::edge_edge, lost).value)) << i;
  }
}

TEST(Distance, OfAPlaneIsSigned) {
  const Vec3 normal = Vec3(1, 2, -2) / 3.0, place(5, 6, 7);
  const Distance below =
      distance(PairKind::point_plane, {place - 0.25 * normal, place, place + normal, {}});
  EXPECT_NEAR(below.value, -0.25, 1e-14);
  EXPECT_LT((below.normal - normal).norm(), 1e-14);
}

}  // namespace
}  // namespace retiarius

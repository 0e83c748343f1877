#include "retiarius/net/outline.hpp"

#include "nets.hpp"

namespace retiarius {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A unit square with its centre, cut by both diagonals; pieces of the rim are border on demand.
Layout crossed_square(bool border) {
  Layout layout;
  layout.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0.5, 0.5, 0)};
  for (Index i = 0; i < 4; ++i) add_line(layout, {i, (i + 1) % 4}, 1.0, border);
  add_line(layout, {0, 4, 2}, 0.7, false);
  add_line(layout, {1, 4, 3}, 0.7, false);
  layout.corners = {2, 3, 0, 1};
  return layout;
}

TEST(HullCorners, RunCounterClockwiseFromPlusX) {
  EXPECT_THAT(hull_corners({Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 2, 0)}),
              ElementsAre(3, 2, 0, 1))
      << "node 1 lies below +x from their mean";
  EXPECT_THAT(hull_corners({Vec3(0, -1, 0), Vec3(1, -1e-6, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)}),
              ElementsAre(1, 3, 2, 0))
      << "but not by rounding in a file";
  EXPECT_THAT(hull_corners({Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)}),
              ElementsAre(1, 3, 2, 0));
}

TEST(HullCorners, LeaveOutNodesOnSidesAndInside) {
  EXPECT_THAT(hull_corners({Vec3(-1, -1, 0), Vec3(0, -1 - 1e-6, 0), Vec3(1, -1, 0), Vec3(0, 0, 0),
                            Vec3(1, 1, 0), Vec3(-1, 1, 0), Vec3(-1 - 1e-7, 0, 0)}),
              ElementsAre(4, 5, 0, 2));
}

TEST(HullCorners, NoneOnALine) {
  EXPECT_THAT(hull_corners({Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(3, 3, 0)}), IsEmpty());
  EXPECT_THAT(hull_corners({Vec3(1, 1, 0)}), IsEmpty());
}

TEST(FindOutline, OuterFaceOrBorderLoop) {
  EXPECT_THAT(find_outline(crossed_square(false)), ElementsAre(2, 3, 0, 1));
  EXPECT_THAT(find_outline(crossed_square(true)), ElementsAre(2, 3, 0, 1));
}

TEST(FindOutline, BorderLoopInsideTheOuterFaceWins) {
  Layout layout = crossed_square(true);
  layout.nodes.emplace_back(3, 0.5, 0);
  add_line(layout, {1, 5, 2}, 2.0, false);
  EXPECT_THAT(find_outline(layout), ElementsAre(2, 3, 0, 1));
  layout.pieces[1].border = false;  // the loop is open: the outer face counts
  EXPECT_THAT(find_outline(layout), ElementsAre(2, 3, 0, 8, 9));
}

TEST(FindOutline, EmptyWhereThereIsNoLoopThroughCornerZero) {
  Layout loose_end = crossed_square(false);
  loose_end.nodes.emplace_back(2, 2, 0);
  add_line(loose_end, {2, 5}, 1.4, false);
  EXPECT_THAT(find_outline(loose_end), IsEmpty());
  Layout inner_corner = crossed_square(false);
  inner_corner.corners = {4};
  EXPECT_THAT(find_outline(inner_corner), IsEmpty());
}

TEST(DoubledArea, HasTheSignOfTheTurn) {
  const std::vector<Vec3> nodes = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 3, 0)};
  EXPECT_EQ(doubled_area(nodes, {0, 1, 2}), 6.0);
  EXPECT_EQ(doubled_area(nodes, {2, 1, 0}), -6.0);
}

}  // namespace
}  // namespace retiarius

#include "retiarius/render/depth_map.hpp"

#include <gtest/gtest.h>

namespace retiarius::render {
namespace {

Place at(double x, double y, double depth) { return {x, y, depth, 1.0}; }

TEST(DepthMap, HidesWhatIsBehindATriangleAndNothingElse) {
  DepthMap map({10.0, 10.0, 100.0, 100.0});
  map.add({at(20, 20, 5), at(100, 20, 5), at(20, 100, 5)});
  EXPECT_TRUE(map.hides(at(40, 40, 6), 0.5));
  EXPECT_FALSE(map.hides(at(40, 40, 5.4), 0.5));
  EXPECT_FALSE(map.hides(at(40, 40, 4), 0.5));
  EXPECT_FALSE(map.hides(at(90, 90, 6), 0.5));
  EXPECT_FALSE(map.hides(at(5, 5, 6), 0.5));
  EXPECT_FALSE(map.hides(at(500, 40, 6), 0.5));
}

TEST(DepthMap, KeepsTheNearestOfSeveralInEitherOrder) {
  for (bool near_first : {true, false}) {
    DepthMap map({0.0, 0.0, 50.0, 50.0});
    map.add({at(0, 0, near_first ? 2 : 8), at(50, 0, near_first ? 2 : 8),
             at(0, 50, near_first ? 2 : 8)});
    map.add({at(0, 0, near_first ? 8 : 2), at(0, 50, near_first ? 8 : 2),
             at(50, 0, near_first ? 8 : 2)});
    EXPECT_TRUE(map.hides(at(10, 10, 3), 0.1));
  }
}

// Half way on paper between depths 2 and 6 the surface is at 1 / ((1/2 + 1/6) / 2) = 3.
TEST(DepthMap, InterpolatesInPerspective) {
  DepthMap map({0.0, 0.0, 200.0, 200.0});
  map.add({at(0, 0, 2), at(200, 0, 6), at(0, 200, 2)});
  map.add({at(200, 200, 6), at(200, 0, 6), at(0, 200, 2)});
  EXPECT_TRUE(map.hides(at(100.5, 0.5, 3.1), 0.0));
  EXPECT_FALSE(map.hides(at(100.5, 0.5, 2.9), 0.0));
}

}  // namespace
}  // namespace retiarius::render

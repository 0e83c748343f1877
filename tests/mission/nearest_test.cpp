#include "retiarius/mission/nearest.hpp"

#include <gtest/gtest.h>

namespace retiarius {
namespace {

TEST(Nearest, CountsEdits) {
  EXPECT_EQ(edit_distance("radius", "radius"), 0);
  EXPECT_EQ(edit_distance("radis", "radius"), 1);
  EXPECT_EQ(edit_distance("radiuss", "radius"), 1);
  EXPECT_EQ(edit_distance("redius", "radius"), 1);
  EXPECT_EQ(edit_distance("raduis", "radius"), 1);
  EXPECT_EQ(edit_distance("Radius", "radius"), 0);
  EXPECT_EQ(edit_distance("", "radius"), 6);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Nearest, FindsTheNearestOrNone) {
  EXPECT_EQ(nearest("desity", {"radius", "density"}), "density");
  EXPECT_EQ(nearest("wide", {"time", "widest"}), "widest");  // as near, but begins alike
  EXPECT_EQ(nearest("stiffness", {"radius", "density"}), std::nullopt);
  EXPECT_EQ(nearest("x", {"y"}), std::nullopt);
  EXPECT_EQ(nearest(std::string(100000, 'a'), {"radius"}), std::nullopt);
}

TEST(Nearest, SuggestsOrLists) {
  EXPECT_EQ(suggestion("desity", {"radius", "density"}), ", did you mean density?");
  EXPECT_EQ(suggestion("zzz", {"radius", "density"}), "; allowed: radius, density");
}

}  // namespace
}  // namespace retiarius

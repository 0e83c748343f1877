#include "retiarius/measure/frame.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tiny_nets.hpp"

namespace retiarius {
namespace {

TEST(Frame, ShowsTheThreadsOfThePresentState) {
  Network net = make_net({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}}, {{0, 1}, {1, 2}}, 100.0, 0.5);
  net.joints = {{0, 1, 2, 0, 1, 0.75, 1.0}};
  net.materials[0].bending = Bending::bounded;
  const std::vector<Body> none;
  const Simulation sim = start(net, none);
  const Frame frame = make_frame(sim, 3);
  EXPECT_EQ(frame.phase, 3);
  EXPECT_EQ(frame.state, &sim.state());
  ASSERT_EQ(frame.strain.size(), 2U);
  EXPECT_NEAR(frame.strain[0], 1.0, 1e-15);
  EXPECT_NEAR(frame.strain[1], 1.0, 1e-15);
  ASSERT_EQ(frame.tension.size(), 2U);
  EXPECT_NEAR(frame.tension[0], 100.0, 1e-12);
  ASSERT_EQ(frame.curvature.size(), 3U);
  EXPECT_NEAR(frame.curvature[1], std::sqrt(2.0) / 0.75, 1e-12);  // 2 sin(90 deg / 2) / lv
  EXPECT_EQ(frame.curvature[0], 0.0);
}

}  // namespace
}  // namespace retiarius

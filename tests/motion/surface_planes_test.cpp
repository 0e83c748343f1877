// Eight nodes at a time against their planes, and one at a time.
#include "retiarius/motion/surface_planes.hpp"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "retiarius/base/instruction_set.hpp"

namespace retiarius {
namespace {

using ::testing::UnorderedElementsAreArray;

constexpr double kRadius = 1e-3;  // m, far from which a node need not be watched

// Shared nodes at 4 i, others in rows of 3 x 8 behind; some of both are watched.
struct Watched {
  static constexpr std::size_t kShared = 24, kRows = 9;
  std::vector<SweepLayout::Slot> slots;
  std::vector<SurfacePlanes::Plane> planes;
  std::vector<double> x, v, gaps;
  std::vector<Vec3> velocities;
  SurfacePlanes watched;

  explicit Watched(int seed) : x(4 * kShared + 24 * kRows), v(x.size()) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (double& value : x) value = number(random);
    for (double& value : v) value = number(random);
    for (std::size_t i = 0; i < kShared; ++i)
      if (number(random) > 0.0) slots.push_back({static_cast<long>(4 * i), 1});
    for (std::size_t row = 0; row < kRows; ++row)
      for (std::size_t lane = 0; lane < 8; ++lane)
        if (number(random) > 0.5)
          slots.push_back({static_cast<long>(4 * kShared + 24 * row + lane), 8});
    watched.lay_out(slots, static_cast<long>(x.size()));
    for (std::size_t k = 0; k < slots.size(); ++k) {
      SurfacePlanes::Plane plane;
      const Vec3 away(number(random), number(random), number(random));
      plane.origin = at(x, k) + 1e-3 * away;
      plane.normal = away.normalized();
      plane.gap = 1e-3 * (1.0 + number(random));
      plane.reach = 1e-6 * (0.6 + number(random));
      planes.push_back(plane);
      watched.set_plane(k, plane);
      watched.set_far(k, kRadius);
      gaps.push_back(number(random));
      velocities.push_back({number(random), number(random), number(random)});
      watched.set_motion(k, gaps.back(), velocities.back());
    }
  }

  Vec3 at(const std::vector<double>& array, std::size_t k) const {
    const double* p = array.data() + slots[k].offset;
    return {p[0], p[slots[k].stride], p[2 * slots[k].stride]};
  }
  double gap(std::size_t k) const {
    return planes[k].gap + planes[k].normal.dot(at(x, k) - planes[k].origin);
  }
  bool clear(std::size_t k) const {
    return gap(k) >= 0.0 && (at(x, k) - planes[k].origin).squaredNorm() <= planes[k].reach;
  }
};

TEST(SurfacePlanes, KeepWhatIsClearAndTellTheOthersWithAllKernels) {
  for (const std::string_view kernels : available_kernels()) {
    set_kernels(kernels);
    int touched = 0, clear = 0;
    for (int seed = 0; seed < 20; ++seed) {
      Watched net(seed);
      bool far = false, expected_far = false;
      std::vector<int> expected;
      for (std::size_t k = 0; k < net.slots.size(); ++k) {
        if (!net.clear(k)) expected.push_back(static_cast<int>(k));
        expected_far |= net.clear(k) && net.gap(k) > kRadius;
      }
      EXPECT_THAT(net.watched.touched(net.x.data(), net.v.data(), far),
                  UnorderedElementsAreArray(expected));
      EXPECT_EQ(far, expected_far);
      for (std::size_t k = 0; k < net.slots.size(); ++k) {
        const bool stays = !net.clear(k);
        EXPECT_NEAR(net.watched.gap(k), stays ? net.gaps[k] : net.gap(k), 1e-17);
        EXPECT_EQ(net.watched.velocity(k), stays ? net.velocities[k] : net.at(net.v, k));
        ++(stays ? touched : clear);
      }
    }
    EXPECT_GT(touched, 100) << kernels;
    EXPECT_GT(clear, 100) << kernels;
  }
  set_kernels("auto");
}

TEST(SurfacePlanes, OfNoNodesAreClear) {
  SurfacePlanes planes;
  planes.lay_out({}, 0);
  bool far = false;
  EXPECT_TRUE(planes.touched(nullptr, nullptr, far).empty());
  EXPECT_FALSE(far);
}

// Nodes that are far are told of even where others are not clear, and those that are kept are not.
TEST(SurfacePlanes, TellOfTheFar) {
  const std::vector<double> x{0, 0, 2, 0, 0, 0, 0, 0}, v(8, 0.0);
  SurfacePlanes planes;
  planes.lay_out({{0, 1}, {4, 1}}, 8);
  for (const std::size_t k : {0, 1}) planes.set_plane(k, {Vec3::Zero(), Vec3::UnitZ(), -1, 100});
  for (const double bound : {0.5, 1.5, kInfinity}) {
    planes.set_far(0, bound);
    bool far = false;
    EXPECT_THAT(planes.touched(x.data(), v.data(), far), ::testing::ElementsAre(1));
    EXPECT_EQ(far, bound < 1.0) << bound;
    EXPECT_EQ(planes.gap(0), 1.0);
  }
}

}  // namespace
}  // namespace retiarius

#include "retiarius/contact/thread_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/contact/collision_scene.hpp"
#include "tests/contact/tangle.hpp"

namespace retiarius {
namespace {

using testing::Stream;

constexpr double kMargin = 0.01, kSlack = 0.02;

// A tangle of threads.
struct Tangle {
  Network net;
  CollisionScene scene;
  std::vector<Vec3> x, still;

  Tangle(std::uint64_t seed, int threads, int segments) {
    Stream random(seed);
    Material material;
    material.radius = 0.004;
    net.materials = {material};
    for (int t = 0; t < threads; ++t) testing::add_thread(net, x, random, 0.6, segments);
    still.assign(x.size(), Vec3::Zero());
    scene = make_collision_scene(net, {});
  }
};

bool includes(const PairParts::List& all, const PairParts::List& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

// Motions that go on from each other, with jumps of some nodes or of all: whatever was held before,
// no pair is missing that a search of its own finds, none that cannot be a pair is there, and those
// that held boxes add are not many.
TEST(ThreadPairs, HeldMissesNothing) {
  Tangle s(3, 20, 15);
  const ThreadNeighbours neighbours(s.net);
  ThreadPairs held(s.scene.net, &neighbours, kSlack);
  Stream random(4);
  std::size_t most_extra = 0;
  for (int round = 0; round < 60; ++round) {
    const Vec3 common = random.vector(0.5);
    const double size = round % 10 == 9 ? 0.2 : 0.01;
    std::vector<Vec3> dx = s.still;
    for (std::size_t i = 0; i < dx.size(); ++i)
      if (round % 10 != 4 || i % 7 == 0) dx[i] = random.vector(size);
    for (Vec3& move : dx) move += common;
    ThreadPairs fresh(s.scene.net, &neighbours, 0.0);
    const PairParts::List exact = fresh.find(s.x, dx, kMargin);
    const PairParts::List& found = held.find(s.x, dx, kMargin);
    ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
    ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    ASSERT_TRUE(includes(found, exact)) << round;
    for (const ContactPair& pair : found) {
      ASSERT_LT(pair.first, pair.second);
      ASSERT_FALSE(neighbours.are_neighbours(pair.first, pair.second));
    }
    most_extra = std::max(most_extra, found.size() - exact.size());
    if (round % 3 == 0)
      for (std::size_t i = 0; i < dx.size(); ++i) s.x[i] += dx[i];
  }
  EXPECT_GT(most_extra, 20u);
  EXPECT_LT(most_extra, 5000u);
}

TEST(ThreadPairs, StandWhereNothingLeavesItsBox) {
  Tangle s(5, 20, 15);
  ThreadPairs pairs(s.scene.net, nullptr, kSlack);
  const PairParts::List first = pairs.find(s.x, s.still, kMargin);
  Stream random(6);
  const Vec3 away = random.vector(100.0);
  std::vector<Vec3> dx = s.still;
  for (std::size_t i = 0; i < dx.size(); ++i) {
    s.x[i] += away;  // that of all of it changes nothing
    dx[i] = random.vector(0.5 * kSlack) + Vec3(3.0, 2.0, 1.0);
  }
  EXPECT_EQ(pairs.find(s.x, dx, kMargin), first);
  EXPECT_GT(first.size(), 100u);
}

// Those of one segment that leaves are looked for anew; all others stand.
TEST(ThreadPairs, FollowOneSegmentThatLeaves) {
  Tangle s(7, 20, 15);
  ThreadPairs pairs(s.scene.net, nullptr, kSlack);
  const PairParts::List first = pairs.find(s.x, s.still, kMargin);
  std::vector<Vec3> dx = s.still;
  dx[0] = -s.x[0];
  const PairParts::List second = pairs.find(s.x, dx, kMargin);
  const auto of_others = [](const PairParts::List& list) {
    PairParts::List rest;
    std::copy_if(list.begin(), list.end(), std::back_inserter(rest),
                 [](const ContactPair& pair) { return pair.first > 0; });
    return rest;
  };
  EXPECT_EQ(of_others(second), of_others(first));
  EXPECT_NE(second, first);
}

TEST(ThreadPairs, AreTheSameForAnyNumberOfThreads) {
  std::vector<PairParts::List> results;
  for (const int count : {1, 2, 4}) {
    set_threads(count);
    Tangle s(8, 60, 40);
    ThreadPairs pairs(s.scene.net, nullptr, kSlack);
    pairs.find(s.x, s.still, kMargin);
    for (std::size_t i = 0; i < s.x.size(); i += 5) s.x[i] += Vec3(0.05, 0.0, 0.0);
    results.push_back(pairs.find(s.x, s.still, kMargin));
  }
  set_threads(1);
  EXPECT_GT(results[0].size(), 1000u);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

// A place that is no number for once spoils nothing that comes after.
TEST(ThreadPairs, SurvivePlacesThatAreNoNumbers) {
  Tangle s(9, 20, 15);
  ThreadPairs pairs(s.scene.net, nullptr, kSlack);
  const PairParts::List first = pairs.find(s.x, s.still, kMargin);
  const std::vector<Vec3> good = s.x;
  s.x[3].x() = std::nan("");
  pairs.find(s.x, s.still, kMargin);
  EXPECT_TRUE(includes(pairs.find(good, s.still, kMargin), first));
}

}  // namespace
}  // namespace retiarius

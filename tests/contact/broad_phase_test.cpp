#include "retiarius/contact/broad_phase.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "retiarius/base/parallel.hpp"
#include "retiarius/contact/distance.hpp"
#include "tests/contact/tangle.hpp"

namespace retiarius {
namespace {

using testing::Stream;

// A tangle of threads and some bodies of every kind, all in motion.
struct MovingScene {
  Network net;
  std::vector<Body> bodies;
  CollisionScene scene;
  std::vector<Vec3> x, dx;
  std::vector<BodyTwist> twists;
  std::vector<bool> fixed;

  MovingScene(std::uint64_t seed, int threads, int segments) {
    Stream random(seed);
    Material material;
    material.radius = 0.004;
    net.materials = {material};
    for (int k = 0; k < threads; ++k) testing::add_thread(net, x, random, 1.0, segments);
    dx.resize(x.size());
    const Vec3 common = random.vector(0.3);
    for (Vec3& move : dx) move = common + random.vector(0.03);
    for (const ShapeKind kind : {ShapeKind::sphere, ShapeKind::capsule, ShapeKind::box,
                                 ShapeKind::cylinder, ShapeKind::plane, ShapeKind::cone})
      add_body(random, kind);
    scene = make_collision_scene(net, bodies);
  }

  void add_body(Stream& random, ShapeKind kind) {
    BodySpec spec;
    spec.shape = kind;
    spec.radius = 0.3;
    spec.length = 0.6;
    spec.size = Vec3(0.3, 0.5, 0.02);
    spec.density = 100.0;
    spec.motion = kind == ShapeKind::plane ? BodyMotion::fixed : BodyMotion::free;
    spec.position = kind == ShapeKind::plane ? Vec3(0, 0, -0.9) : random.vector(0.7);
    if (kind == ShapeKind::plane) spec.density.reset();
    bodies.push_back(build_body(spec, "."));
    BodyTwist twist = at_rest(bodies.back().initial);
    fixed.push_back(kind == ShapeKind::plane);
    if (kind != ShapeKind::plane) {
      twist.translation = random.vector(0.3);
      twist.rotation = random.vector(0.5);
    }
    twists.push_back(twist);
  }

  // The smallest distance of a pair along the motion, sampled.
  double smallest_distance(const ContactPair& pair) const {
    const PairMotion motion = scene.motion(pair, x, dx, twists);
    double least = kInfinity;
    for (int k = 0; k <= 16; ++k)
      least = std::min(least, distance(pair.kind, motion.at(k / 16.0)).value);
    return least;
  }
};

// Calls call(pair) for every pair that there can be.
template <class Call>
void each_possible_pair(const MovingScene& s, const ThreadNeighbours& neighbours, Call&& call) {
  const auto segments = static_cast<Index>(s.net.segments.size());
  for (Index i = 0; i < segments; ++i)
    for (Index j = i + 1; j < segments; ++j)
      if (!neighbours.are_neighbours(i, j)) call({PairKind::edge_edge, kNet, i, kNet, j});
  const auto count = [](const auto& list) { return static_cast<Index>(list.size()); };
  for (Index b = 0; b < count(s.bodies); ++b) {
    const CollisionMesh& mesh = s.scene.bodies[b];
    for (Index n = 0; n < count(s.x); ++n) {
      if (mesh.half_space) call({PairKind::point_plane, kNet, n, b, 0});
      for (Index t = 0; t < count(mesh.triangles); ++t)
        call({PairKind::point_triangle, kNet, n, b, t});
    }
    for (Index i = 0; i < segments; ++i) {
      if (mesh.points.size() == 1) call({PairKind::point_edge, b, 0, kNet, i});
      for (Index e = 0; e < count(mesh.edges); ++e) call({PairKind::edge_edge, kNet, i, b, e});
    }
    for (Index c = 0; c < count(s.bodies); ++c) {
      if (b == c) continue;
      const CollisionMesh& other = s.scene.bodies[c];
      for (const Index p : mesh.corners) {
        if (other.half_space) call({PairKind::point_plane, b, p, c, 0});
        for (Index t = 0; t < count(other.triangles); ++t)
          call({PairKind::point_triangle, b, p, c, t});
      }
      if (mesh.points.size() == 1 && other.edges.size() == 1)
        call({PairKind::point_edge, b, 0, c, 0});
      for (Index e = 0; b < c && e < count(mesh.edges); ++e)
        for (Index f = 0; f < count(other.edges); ++f) call({PairKind::edge_edge, b, e, c, f});
    }
  }
}

TEST(BroadPhase, MissesNoPairThatComesNear) {
  constexpr double kMargin = 0.01;
  std::size_t near = 0, found_count = 0, possible = 0;
  std::set<PairKind> kinds;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const MovingScene s(seed, 8, 12);
    const ThreadNeighbours neighbours(s.net);
    BroadPhase broad(s.scene, &neighbours, {true, s.fixed});
    const std::vector<ContactPair>& found = broad.find(s.x, s.dx, s.twists, kMargin);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    found_count += found.size();
    std::size_t known = 0;
    each_possible_pair(s, neighbours, [&](const ContactPair& pair) {
      ++possible;
      const bool listed = std::binary_search(found.begin(), found.end(), pair);
      known += listed;
      if (s.smallest_distance(pair) > s.scene.thickness(pair) + kMargin) return;
      ++near;
      kinds.insert(pair.kind);
      ASSERT_TRUE(listed) << static_cast<int>(pair.kind) << " " << pair.first_owner << "/"
                          << pair.first << " " << pair.second_owner << "/" << pair.second;
    });
    EXPECT_EQ(known, found.size());  // nothing that cannot be a pair
  }
  EXPECT_GE(kinds.size(), 4u);
  EXPECT_GT(near, 1000u);
  EXPECT_LT(found_count, possible / 10);
}

// Thread on thread the candidates are exactly those whose swept boxes overlap.
TEST(BroadPhase, OfThreadsIsThatOfAllPairsOfBoxes) {
  constexpr double kMargin = 0.1;
  std::size_t count = 0;
  for (std::uint64_t seed = 11; seed <= 14; ++seed) {
    const MovingScene s(seed, 20, 20);
    const ThreadNeighbours neighbours(s.net);
    std::vector<Box> boxes;
    Vec3 drift = Vec3::Zero();
    for (const Vec3& move : s.dx) drift += move / static_cast<double>(s.dx.size());
    for (const Segment& segment : s.net.segments) {
      Box box;
      for (const Index n : {segment.a, segment.b}) {
        box.extend(s.x[n]);
        box.extend(Vec3(s.x[n] + s.dx[n] - drift));
      }
      const Vec3 wide = Vec3::Constant(0.004 + 0.5 * kMargin);
      boxes.emplace_back(box.min() - wide, box.max() + wide);
    }
    std::vector<ContactPair> expected;
    for (Index i = 0; i < static_cast<Index>(boxes.size()); ++i)
      for (Index j = i + 1; j < static_cast<Index>(boxes.size()); ++j)
        if (boxes[i].intersects(boxes[j]) && !neighbours.are_neighbours(i, j))
          expected.push_back({PairKind::edge_edge, kNet, i, kNet, j});
    const CollisionScene threads{s.scene.net, {}};
    BroadPhase broad(threads, &neighbours, {true, {}});
    EXPECT_EQ(broad.find(s.x, s.dx, {}, kMargin), expected);
    count += expected.size();
  }
  EXPECT_GT(count, 100u);
}

TEST(BroadPhase, IsTheSameForAnyNumberOfThreads) {
  const MovingScene s(21, 60, 40);
  const ThreadNeighbours neighbours(s.net);
  std::vector<std::vector<ContactPair>> results;
  for (const int count : {1, 2, 4}) {
    set_threads(count);
    BroadPhase broad(s.scene, &neighbours, {true, s.fixed});
    broad.find(s.x, s.dx, s.twists, 0.05);
    results.push_back(broad.find(s.x, s.dx, s.twists, 0.01));  // what came before leaves no trace
  }
  set_threads(1);
  EXPECT_GT(results[0].size(), 1000u);
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

TEST(BroadPhase, LeavesOutFixedBodiesAndSelfContactUnlessAsked) {
  const MovingScene s(31, 6, 10);
  const ThreadNeighbours neighbours(s.net);
  BroadPhase broad(s.scene, nullptr, {false, std::vector<bool>(s.bodies.size(), true)});
  for (const ContactPair& pair : broad.find(s.x, s.dx, s.twists, 0.01))
    EXPECT_NE(pair.first_owner == kNet, pair.second_owner == kNet);
  EXPECT_FALSE(broad.pairs().empty());
}

TEST(BroadPhase, FindsNothingFarAway) {
  MovingScene s(41, 6, 10);
  for (Vec3& p : s.x) p += Vec3(100, 0, 100);
  BroadPhase broad(s.scene, nullptr, {false, std::vector<bool>(s.bodies.size(), true)});
  EXPECT_TRUE(broad.find(s.x, s.dx, s.twists, 0.01).empty());
}

}  // namespace
}  // namespace retiarius

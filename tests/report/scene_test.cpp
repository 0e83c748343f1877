#include "retiarius/report/scene.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "retiarius/report/scene_svg.hpp"
#include "tests/record/sample_run.hpp"

namespace retiarius {
namespace {

using ::testing::HasSubstr;
using testing::SampleRun;

std::size_t pieces(const Scene& scene) {
  std::size_t count = 0;
  for (const auto& line : scene.threads) count += line.size() - 1;
  return count;
}

Scene scene_of(const SampleRun& run, std::size_t lines) {
  return make_scene(net_drawing(run.network), run.network.perimeter, body_drawings(run.model()),
                    lines);
}

TEST(MakeScene, JoinsSegmentsToWholeThreads) {
  const Scene scene = scene_of(SampleRun(4), 5000);
  EXPECT_EQ(scene.threads.size(), 10u);
  EXPECT_EQ(pieces(scene), 40u);
  EXPECT_EQ(scene.nodes.size(), 25u);
  for (const auto& line : scene.threads) EXPECT_EQ(line.size(), 5u);
  EXPECT_EQ(std::count(scene.border.begin(), scene.border.end(), true), 4);
}

TEST(MakeScene, FollowsAThreadWhateverTheOrderOfItsSegments) {
  NetDrawing net;
  net.segments = {{2, 3}, {1, 0}, {2, 1}, {7, 8}};
  net.thread = {0, 0, 0, -1};
  const Scene scene = make_scene(net, {}, {});
  ASSERT_EQ(scene.threads.size(), 2u);
  std::vector<Index> nodes;
  for (Index k : scene.threads[1]) nodes.push_back(scene.nodes[static_cast<std::size_t>(k)]);
  EXPECT_THAT(nodes, ::testing::ElementsAre(0, 1, 2, 3));
}

TEST(MakeScene, ClosesClosedThreads) {
  NetDrawing net;
  net.segments = {{0, 1}, {1, 2}, {2, 0}};
  net.thread = {0, 0, 0};
  const Scene scene = make_scene(net, {}, {});
  ASSERT_EQ(scene.threads.size(), 1u);
  EXPECT_EQ(scene.threads[0].size(), 4u);
  EXPECT_EQ(scene.threads[0].front(), scene.threads[0].back());
}

TEST(MakeScene, LeavesOutNodesAndThreadsOfBigNets) {
  const SampleRun run(60);  // 122 threads of 60 segments
  EXPECT_LE(pieces(scene_of(run, 1000)), 1100u);
  const Scene few = scene_of(run, 50);
  EXPECT_LE(pieces(few), 100u);
  EXPECT_GE(few.threads.size(), 20u);
}

TEST(Coarsened, HasFewerTrianglesInTheSamePlace) {
  TriangleMesh sheet;
  const int n = 60;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) sheet.vertices.emplace_back(i / 60.0, j / 60.0, 0.0);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const Index k = j * (n + 1) + i;
      sheet.triangles.push_back({k, k + 1, k + n + 1});
      sheet.triangles.push_back({k + 1, k + n + 2, k + n + 1});
    }
  const TriangleMesh coarse = coarsened(sheet, 1000);
  EXPECT_LE(coarse.triangles.size(), 1000u);
  EXPECT_GE(coarse.triangles.size(), 200u);
  EXPECT_EQ(coarsened(sheet, 10000).triangles.size(), sheet.triangles.size());
}

TEST(SceneSvg, HasNetBodyScaleAndATextAlternative) {
  const SampleRun run;
  const Scene scene = scene_of(run, 5000);
  const State state = run.state(0.0);
  const Picture picture = make_picture(scene, 0.0, 0, state.x, state.bodies);
  const std::string svg = scene_svg(scene, picture, "a \"net\"");
  EXPECT_THAT(svg, HasSubstr("role=\"img\" aria-label=\"a &quot;net&quot;\""));
  EXPECT_THAT(svg, HasSubstr("<path class=\"net\" d=\"M"));
  EXPECT_THAT(svg, ::testing::ContainsRegex("class=\"b[0-7]\" d=\"M[^\"]*Z"));
  EXPECT_THAT(svg, HasSubstr(" m</text>"));
}

// What lies nearer to the viewer is drawn later.
TEST(SceneSvg, DrawsNearPartsOverFarParts) {
  const SampleRun run;
  const Scene scene = scene_of(run, 5000);
  State state = run.state(0.0);
  const auto drawn_last = [&](double z) {
    state.bodies[0].position = Vec3(0, 0, z);
    const std::string svg =
        scene_svg(scene, make_picture(scene, 0.0, 0, state.x, state.bodies), "");
    return svg.rfind("class=\"b") > svg.rfind("class=\"net");
  };
  EXPECT_TRUE(drawn_last(20.0));  // above the flat net, seen from above
  EXPECT_FALSE(drawn_last(-20.0));
}

}  // namespace
}  // namespace retiarius

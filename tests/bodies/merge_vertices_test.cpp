#include "retiarius/bodies/merge_vertices.hpp"

#include <gtest/gtest.h>

namespace retiarius {
namespace {

TEST(MergeVertices, JoinsWhatIsNearAndDropsWhatIsUnused) {
  const TriangleMesh loose{
      {{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {1e-7, 0, 0}, {1, 0, -0.0}, {0, 0, 1}},
      {{0, 2, 3}, {4, 6, 5}}};
  const TriangleMesh merged = merge_vertices(loose, 1e-6);
  EXPECT_EQ(merged.vertices.size(), 4u);
  EXPECT_EQ(merged.triangles[0], (std::array<Index, 3>{0, 1, 2}));
  EXPECT_EQ(merged.triangles[1], (std::array<Index, 3>{0, 3, 1}));
  EXPECT_EQ(merge_vertices(loose, 1e-8).vertices.size(), 5u);
}

TEST(MergeVertices, JoinsAcrossTheCellsOfItsGrid) {
  // Pairs a little apart on either side of every multiple of the tolerance.
  TriangleMesh loose;
  for (Index k = 0; k < 30; ++k) {
    loose.vertices.emplace_back(10.0 * k - 0.2, 0.0, 0.0);
    loose.vertices.emplace_back(10.0 * k + 0.2, 0.1, -0.1);
    loose.triangles.push_back({2 * k, 2 * k + 1, 0});
  }
  EXPECT_EQ(merge_vertices(loose, 1.0).vertices.size(), 30u);
}

TEST(MeshSize, IsTheDiagonal) {
  EXPECT_DOUBLE_EQ(mesh_size({{{0, 0, 0}, {1, 2, 2}}, {}}), 3.0);
  EXPECT_EQ(mesh_size({}), 0.0);
}

}  // namespace
}  // namespace retiarius

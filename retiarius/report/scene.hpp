// What the report keeps of a run to draw pictures of it: few lines and triangles, whatever the size
// of the net.
#pragma once

#include <string>
#include <vector>

#include "retiarius/record/vtk_frames.hpp"

namespace retiarius {

// The net as lines between some of its nodes, and the bodies' surfaces.
struct Scene {
  std::vector<Index> nodes;                 // those that are drawn, as numbered in the network
  std::vector<std::vector<Index>> threads;  // lines, into `nodes`
  std::vector<bool> border;                 // of each line: is on the outline
  std::vector<TriangleMesh> bodies;         // body axes
};

// One instant of a scene.
struct Picture {
  double time = 0.0;
  Index phase = 0;
  std::vector<Vec3> x;  // of each drawn node
  std::vector<BodyState> bodies;
};

// Joins segments to threads and leaves out nodes, then threads, until at most about `lines`
// straight pieces are left; surfaces of more than `triangles` triangles are coarsened.
Scene make_scene(const NetDrawing& net, const std::vector<Index>& perimeter,
                 const std::vector<BodyDrawing>& bodies, std::size_t lines = 5000,
                 std::size_t triangles = 4000);

Picture make_picture(const Scene& scene, double time, Index phase, const std::vector<Vec3>& x,
                     const std::vector<BodyState>& bodies);

// The same surface with fewer triangles: vertices are merged in the cells of a cubic grid, whose
// size is doubled until at most `limit` triangles are left.
TriangleMesh coarsened(const TriangleMesh& mesh, std::size_t limit);

}  // namespace retiarius

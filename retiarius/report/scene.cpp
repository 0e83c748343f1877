#include "retiarius/report/scene.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace retiarius {

namespace {

using Line = std::vector<Index>;

// The nodes of one thread in order, from its unordered segments; several lines where the segments
// do not hang together.
std::vector<Line> chained(const std::vector<std::array<Index, 2>>& segments) {
  std::map<Index, std::vector<std::size_t>> at;  // segments at each node
  for (std::size_t k = 0; k < segments.size(); ++k)
    for (Index node : segments[k]) at[node].push_back(k);
  std::vector<Index> starts;
  for (const auto& [node, list] : at)
    if (list.size() == 1) starts.push_back(node);
  for (const auto& segment : segments) starts.push_back(segment[0]);  // closed threads
  std::vector<bool> used(segments.size(), false);
  std::vector<Line> lines;
  for (Index start : starts) {
    Line line = {start};
    for (bool found = true; found;) {
      found = false;
      for (std::size_t k : at[line.back()]) {
        if (used[k]) continue;
        used[k] = found = true;
        line.push_back(segments[k][0] == line.back() ? segments[k][1] : segments[k][0]);
        break;
      }
    }
    if (line.size() > 1) lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<Line> lines_of(const NetDrawing& net) {
  std::map<int, std::vector<std::array<Index, 2>>> threads;
  std::vector<Line> lines;
  for (std::size_t k = 0; k < net.segments.size(); ++k) {
    const int thread = static_cast<int>(net.thread[k]);
    if (thread < 0)
      lines.push_back({net.segments[k][0], net.segments[k][1]});
    else
      threads[thread].push_back(net.segments[k]);
  }
  for (const auto& [thread, segments] : threads)
    for (Line& line : chained(segments)) lines.push_back(std::move(line));
  return lines;
}

Line every(const Line& line, std::size_t stride) {
  Line kept;
  for (std::size_t k = 0; k + 1 < line.size(); k += stride) kept.push_back(line[k]);
  kept.push_back(line.back());
  return kept;
}

}  // namespace

TriangleMesh coarsened(const TriangleMesh& mesh, std::size_t limit) {
  if (mesh.triangles.size() <= limit || mesh.vertices.empty()) return mesh;
  Vec3 low = mesh.vertices[0], high = low;
  for (const Vec3& x : mesh.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  TriangleMesh coarse;
  for (double cell = (high - low).maxCoeff() / 128;; cell *= 2) {
    coarse = {};
    std::map<std::array<int, 3>, Index> cells;
    std::vector<Index> merged;
    for (const Vec3& x : mesh.vertices) {
      const Eigen::Vector3i c = ((x - low) / cell).cast<int>();
      const auto [entry, added] =
          cells.try_emplace({c.x(), c.y(), c.z()}, static_cast<Index>(coarse.vertices.size()));
      if (added) coarse.vertices.push_back(x);
      merged.push_back(entry->second);
    }
    for (const auto& triangle : mesh.triangles) {
      std::array<Index, 3> t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = merged[static_cast<std::size_t>(triangle[k])];
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) coarse.triangles.push_back(t);
    }
    if (coarse.triangles.size() <= limit) return coarse;
  }
}

Scene make_scene(const NetDrawing& net, const std::vector<Index>& perimeter,
                 const std::vector<BodyDrawing>& bodies, std::size_t lines, std::size_t triangles) {
  const std::set<Index> outline(perimeter.begin(), perimeter.end());
  const std::vector<Line> all = lines_of(net);
  const std::size_t limit = std::max<std::size_t>(1, lines);
  // Of how many threads one is drawn, and of how many nodes of a thread one.
  const std::size_t skip = std::max<std::size_t>(1, (all.size() + limit - 1) / limit);
  const std::size_t pieces = net.segments.size() / skip;
  const std::size_t stride = std::max<std::size_t>(1, (pieces + limit - 1) / limit);
  Scene scene;
  std::map<Index, Index> drawn;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool border = std::all_of(all[k].begin(), all[k].end(),
                                    [&](Index node) { return outline.count(node) > 0; });
    if (k % skip != 0) continue;
    Line line = every(all[k], stride);
    for (Index& node : line) {
      const auto [entry, added] = drawn.try_emplace(node, static_cast<Index>(scene.nodes.size()));
      if (added) scene.nodes.push_back(node);
      node = entry->second;
    }
    scene.threads.push_back(std::move(line));
    scene.border.push_back(border);
  }
  for (const BodyDrawing& body : bodies) scene.bodies.push_back(coarsened(body.mesh, triangles));
  return scene;
}

Picture make_picture(const Scene& scene, double time, Index phase, const std::vector<Vec3>& x,
                     const std::vector<BodyState>& bodies) {
  Picture picture{time, phase, {}, bodies};
  for (Index node : scene.nodes) picture.x.push_back(x[static_cast<std::size_t>(node)]);
  return picture;
}

}  // namespace retiarius

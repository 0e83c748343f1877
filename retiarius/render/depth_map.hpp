// How far the nearest body is from the camera at each point of a picture.
#pragma once

#include <array>
#include <vector>

#include "retiarius/render/camera.hpp"

namespace retiarius::render {

// A raster of depths. The reciprocal of depth is linear across a triangle on paper, which makes the
// interpolation exact in perspective.
class DepthMap {
 public:
  // Covers the area with cells of the picture's unit.
  explicit DepthMap(const Area& area);

  void add(const std::array<Place, 3>& triangle);

  // Whether something nearer than depth - tolerance (m) covers the place.
  bool hides(const Place& place, double tolerance) const;

 private:
  double x_, y_;
  int columns_, rows_;
  std::vector<float> nearness_;  // 1/depth of the nearest surface in each cell, 1/m; 0: none
};

}  // namespace retiarius::render

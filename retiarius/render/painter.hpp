// Draws net and bodies of one frame.
#pragma once

#include <array>
#include <vector>

#include <cairo.h>

#include "retiarius/render/camera.hpp"
#include "retiarius/render/depth_map.hpp"
#include "retiarius/render/drawn_run.hpp"
#include "retiarius/render/quantity.hpp"

namespace retiarius::render {

// How threads are coloured, and how much larger than usual lines and letters are.
struct Look {
  Quantity quantity = Quantity::none;
  double high = 1.0;   // upper end of the colours' range
  double size = 1.0;   // 1 for a picture of 1200 x 900
  bool bodies = true;  // whether they are drawn
};

// A part of a body's surface, or an edge of it (two places).
struct SurfacePiece {
  std::array<Place, 3> corner;
  int count = 3;
  double depth = 0.0;  // m, of its middle
  Colour colour;
};

// A straight run of thread or a ball (both ends in one place), wholly in front of or wholly behind
// the bodies.
struct ThreadPiece {
  Place from, to;
  double depth = 0.0;  // m, of its middle
  double width = 1.0;  // on paper; of a ball its diameter
  bool hidden = false;
  bool ball = false;
  Colour colour;
  double light = 1.0;  // 0 to 1, by direction
};

std::vector<SurfacePiece> surface_pieces(const DrawnRun& run, const FrameData& frame,
                                         const Camera& camera, bool bodies, DepthMap& depths);
std::vector<ThreadPiece> thread_pieces(const DrawnRun& run, const FrameData& frame,
                                       const Camera& camera, const DepthMap& depths,
                                       const Look& look);

// Hidden surfaces: what of the threads lies behind a body, as the depth map says, is drawn first,
// then surfaces from far to near in small pieces, then the other threads from far to near.
void draw_scene(cairo_t* context, const DrawnRun& run, const FrameData& frame, const Camera& camera,
                const Area& area, const Look& look);

}  // namespace retiarius::render

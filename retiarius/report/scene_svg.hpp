// Pictures of a scene seen from a fixed direction without perspective.
#pragma once

#include <string>

#include "retiarius/report/scene.hpp"

namespace retiarius {

// The picture as SVG: the farthest parts are drawn first, surfaces are shaded by one lamp, a bar
// tells the scale. +z points up on the paper. `alternative` is its text for who cannot see it.
std::string scene_svg(const Scene& scene, const Picture& picture, const std::string& alternative);

}  // namespace retiarius

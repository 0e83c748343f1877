// Missions that take milliseconds.
#pragma once

#include <string>
#include <vector>

#include "retiarius/mission/reader.hpp"

namespace retiarius::testing {

// A net of one hexagon of triangles, held at its corners, falls for a tenth of a second.
inline Mission falling_net(const std::vector<std::string>& overrides = {}) {
  return parse_mission(R"(title = "A falling net"

[net]
pattern = "hexagon"
side = 1.0
mesh = 0.5
segments = 2

[net.thread]
young_modulus = 1.0e6
density = 1000.0
radius = 0.01

[environment]
gravity = [0.0, 0.0, -50.0]

[integrator]
step = 0.001

[[phase]]
kind = "free"
fix = "corners"
until = "time >= 0.1"

[[probe]]
name = "center"
node = "center"

[output]
interval = 0.01
frame_interval = 0.1
)",
                       "falling.toml", ".", overrides);
}

}  // namespace retiarius::testing

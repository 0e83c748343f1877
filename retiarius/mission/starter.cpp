#include <fmt/format.h>

#include "retiarius/mission/key.hpp"
#include "retiarius/mission/writer.hpp"

namespace retiarius {

namespace {

constexpr const char* kStarter = R"(
# A small hexagon net is shot at a sphere that floats ahead of it.
# SI units throughout; degrees only where a key ends in _deg.
format = 1

[net]
pattern = "hexagon"            # hexagon | square | triangle | polygon | file
side = 2.0                     # m, of the outline
mesh = 0.5                     # m, knot to knot; divides the side
segments = 2                   # per piece of thread between knots
scale = 0.3                    # the net starts drawn together to this share of its size
zigzag = true                  # ... with its slack lifted out of the plane, nothing stretched

[net.thread]
young_modulus = 1.0e9          # Pa
density = 1000.0               # kg/m3
radius = 0.001                 # m
compression = false            # a thread pulls but does not push
material_damping = 1.0e-4      # s

[net.corner_mass]
mass = 0.3                     # kg, one at each corner; by them the net is shot

[target]
shape = "sphere"               # sphere | box | cylinder | capsule | cone | plane | mesh
radius = 0.5                   # m
mass = 50.0                    # kg; a homogeneous solid
position = [0.0, 0.0, 4.0]     # m; the net starts at the origin
spin_deg = [0.0, 5.0, 0.0]     # deg/s

[integrator]
method = "implicit-euler"      # implicit-euler | newmark | midpoint | generalised-alpha | tr-bdf2 | static
step = 0.002                   # s

[contact]
method = "modified-mass"       # none | modified-mass
friction = 0.2

# Phases follow each other; each ends when its `until` comes true.
[[phase]]
kind = "shoot"
speed = 4.0                    # m/s, of the corner masses
half_angle_deg = 35.0          # from the axis; they fly apart and open the net
axis = [0.0, 0.0, 1.0]
until = "phase_time >= 0.05"

[[phase]]
kind = "spread"
until = "contact or widest or time >= 2.0"

[[phase]]
kind = "contact"
until = "time >= 3.0"

# Columns center.x, center.y, ... in history.csv
[[probe]]
name = "center"
node = "center"

[output]
interval = 0.01                # s, between rows of history.csv
frame_interval = 0.05          # s, between frames
)";

}  // namespace

std::string starter_mission(const std::string& name) {
  return fmt::format("title = {}\n", quoted(name)) + kStarter;
}

}  // namespace retiarius

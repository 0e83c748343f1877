// What a mission says about its net: plain data, one struct for each table of the mission file.
#pragma once

#include <optional>
#include <string>

#include "retiarius/base/vec.hpp"

namespace retiarius {

enum class Pattern { hexagon, square, triangle, polygon, file };
enum class Cell { natural, square, diamond };  // natural: the pattern's own (see NetSpec::cell)
enum class Knots { continuous, hinged };
enum class Bending { none, bounded, tangent };

// Table [net.thread]: a thread's material and cross-section.
struct ThreadSpec {
  double young_modulus = 0.0;               // E, Pa; required
  double density = 0.0;                     // rho, kg/m3; required
  double radius = 0.0;                      // r0, m; required
  Bending bending = Bending::none;          // curvature of the bending energy
  std::optional<double> bending_stiffness;  // EI, N m2; absent: solid rod, E pi r0^4 / 4
  bool compression = true;                  // false: tension-only
  double material_damping = 0.0;            // tau, s
  std::optional<double> strength;           // N
};

// Table [net.border]: what differs on the perimeter threads; absent values are the thread's.
struct BorderSpec {
  std::optional<double> young_modulus;      // Pa
  std::optional<double> density;            // kg/m3
  std::optional<double> radius;             // m
  std::optional<double> bending_stiffness;  // N m2
  std::optional<double> strength;           // N
};

// Table [net.corner_mass]: the bullets by which the net is shot.
struct CornerMassSpec {
  double mass = 0.0;        // kg, one at each corner
  double bridle = 0.0;      // m, length of the line between corner and mass; 0: fixed to the corner
  int bridle_segments = 4;  // segments of each bridle
};

// Table [net].
struct NetSpec {
  Pattern pattern = Pattern::hexagon;  // required
  int sides = 6;                       // corners of pattern = "polygon", at least 3
  double side = 0.0;                   // m, length of one side of the outline; required
  // m, knot to knot along the side, which it divides; required. Lines of a polygon's sectors and of
  // the diamond square have pieces of length R mesh / side, R being the outline's circumradius; in
  // all other patterns every piece has the length of the mesh.
  double mesh = 0.0;
  // Mesh of pattern = "square" (square, along the sides, or diamond, at 45 degrees) and "triangle"
  // (natural: three families of threads parallel to the sides; diamond: two families).
  Cell cell = Cell::natural;
  int segments = 1;  // segments per piece
  Knots knots = Knots::continuous;
  double knot_mass = 0.0;  // kg, added at each knot
  double scale = 1.0;      // of the initial positions in the net's plane
  bool zigzag = false;
  double disturbance = 0.0;      // m, random displacement of the start, from the mission's seed
  std::string file;              // network file of pattern = "file" (net/network_file.hpp)
  std::string state;             // run folder or checkpoint that gives the initial positions
  Vec3 position = Vec3::Zero();  // m, where the net's centre is placed
  ThreadSpec thread;
  BorderSpec border;
  CornerMassSpec corner_mass;
};

}  // namespace retiarius
